// three.js reads a .glb or a .bvh and plays it: prints where its joints are at given times, [time][joint][x, y, z], as JSON.
// Arguments: the file, and a JSON list of times [s]. Joints of a .glb are its nodes in their order, those of a .bvh its bones.
import { readFileSync } from 'fs';
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { BVHLoader } from 'three/addons/loaders/BVHLoader.js';

const [path, times] = [process.argv[2], JSON.parse(process.argv[3])];
const bytes = readFileSync(path);

async function glb() {
  const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
  const gltf = await new GLTFLoader().parseAsync(buffer, '');
  const nodes = await gltf.parser.getDependencies('node');
  return { root: gltf.scene, joints: nodes, clips: gltf.animations, names: nodes.map((node) => node.name) };
}

function bvh() {
  const { skeleton, clip } = new BVHLoader().parse(bytes.toString('utf-8'));
  const joints = skeleton.bones.filter((bone) => bone.name !== 'ENDSITE');
  return { root: skeleton.bones[0], joints, clips: [clip], names: joints.map((bone) => bone.name) };
}

const { root, joints, clips, names } = path.endsWith('.bvh') ? bvh() : await glb();
const mixer = new THREE.AnimationMixer(root);
const actions = clips.map((clip) => mixer.clipAction(clip).setLoop(THREE.LoopOnce));
for (const action of actions) { action.clampWhenFinished = true; action.play(); }
const places = times.map((time) => {
  for (const action of actions) { action.paused = false; action.enabled = true; action.time = 0; }
  mixer.setTime(time);
  root.updateMatrixWorld(true);
  return joints.map((joint) => new THREE.Vector3().setFromMatrixPosition(joint.matrixWorld).toArray());
});
console.log(JSON.stringify({ names, places }));
