// The page of an exported run: plays the .glb within it, with timeline, forces and footprints. It asks for nothing from outside.
(async () => {
  'use strict';
  const $ = (id) => document.getElementById(id);
  const run = JSON.parse($('run').textContent);
  const COLOURS = { left: '#eb2ed9', right: '#e61f1f', double: '#1a248c', flight: '#8cccfa' };  // as the paper's figures
  const FORCE = 0.09;  // metres drawn per N/kg: a body's weight is 0.88 m

  async function unpacked(id) {
    const packed = Uint8Array.from(atob($(id).textContent), (letter) => letter.charCodeAt(0));
    $(id).remove();
    return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
  }

  // ------------------------------------------------------------------------------------------------ the scene
  const canvas = $('view');
  const renderer = new THREE.WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = THREE.PCFShadowMap;
  const scene = new THREE.Scene();
  scene.background = new THREE.Color(0xcfdfe8);
  scene.fog = new THREE.Fog(0xcfdfe8, 40, 120);
  scene.add(new THREE.HemisphereLight(0xe8f2fa, 0x9a9478, 2.6));
  const sun = new THREE.DirectionalLight(0xfff3e0, 2.6);
  sun.castShadow = true;
  sun.shadow.mapSize.set(2048, 2048);
  sun.shadow.bias = -0.0005;
  sun.shadow.normalBias = 0.02;
  Object.assign(sun.shadow.camera, { left: -7, right: 7, top: 7, bottom: -7, near: 1, far: 60 });
  scene.add(sun, sun.target);
  const camera = new THREE.PerspectiveCamera(42, 1, 0.05, 400);
  const controls = new THREE.OrbitControls(camera, canvas);
  controls.enableDamping = true;
  controls.maxPolarAngle = 1.53;

  const gltf = await new THREE.GLTFLoader().parseAsync(await unpacked('glb'), '');
  const nodes = await gltf.parser.getDependencies('node');
  scene.add(gltf.scene);
  gltf.scene.traverse((thing) => {
    if (!thing.isMesh) return;
    const body = thing.isSkinnedMesh;
    thing.castShadow = body || thing.name === 'trees' || thing.name === 'rocks';
    thing.receiveShadow = true;
    if (body) thing.frustumCulled = false;
  });
  const mixer = new THREE.AnimationMixer(gltf.scene);
  for (const clip of gltf.animations) mixer.clipAction(clip).play();
  const actors = run.actors.map((actor) => ({ ...actor, root: nodes[actor.node] }));
  const numbers = new Float32Array(await unpacked('numbers'));  // [actor][frame]: com; left foot: point, force; right foot
  const frames = run.frames, WIDTH = 15;
  const at = (who, frame) => (who * frames + frame) * WIDTH;

  // Footprints: those of a kind are drawn at once; each is there from its contact on.
  const printKinds = run.outlines.map((corners, kind) => {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(corners.flatMap(([x, y]) => [y, 0, x])), 3));
    const rows = actors.flatMap((actor) => (actor.kind === kind ? actor.prints : [])).sort((a, b) => a.contact - b.contact);
    const look = new THREE.MeshBasicMaterial({ color: 0x2b2a22, transparent: true, opacity: 0.55, side: 2, depthWrite: false,
      polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -2 });
    const mesh = new THREE.InstancedMesh(geometry, look, Math.max(rows.length, 1));
    rows.forEach((print, k) => {
      const up = new THREE.Vector3(...print.normal), ahead = new THREE.Vector3(...print.ahead);
      const left = new THREE.Vector3().crossVectors(up, ahead).normalize();
      ahead.crossVectors(left, up);
      const place = new THREE.Vector3(...print.place).addScaledVector(up, 0.012);
      mesh.setMatrixAt(k, new THREE.Matrix4().makeBasis(left, up, ahead).setPosition(place));
    });
    mesh.frustumCulled = false;
    scene.add(mesh);
    return { mesh, contacts: rows.map((print) => print.contact) };
  });

  // Forces of the feet of whom is followed, and the curve of its centre of mass in the colours of its phases.
  const arrows = ['left', 'right'].map((side) => {
    const look = new THREE.MeshBasicMaterial({ color: COLOURS[side], depthTest: false, transparent: true, opacity: 0.9 });
    const arrow = new THREE.Group(), shaft = new THREE.Mesh(new THREE.CylinderGeometry(0.012, 0.012, 1, 10).translate(0, 0.5, 0), look);
    const tip = new THREE.Mesh(new THREE.ConeGeometry(0.035, 0.09, 14).translate(0, 0.045, 0), look);
    arrow.add(shaft, tip);
    for (const part of [shaft, tip]) part.renderOrder = 1;  // seen through the body
    scene.add(arrow);
    return { arrow, shaft, tip };
  });
  const curve = new THREE.Line(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ vertexColors: true }));
  curve.frustumCulled = false;
  scene.add(curve);

  const stands = (actor, side, time) => actor.prints.some((p) => p.side === side && p.contact <= time && time < p.leaves);
  function phase(actor, time) {
    const left = stands(actor, 0, time), right = stands(actor, 1, time);
    return left ? (right ? 'double' : 'left') : right ? 'right' : 'flight';
  }

  function layCurve() {
    const points = new Float32Array(frames * 3), colours = new Float32Array(frames * 3), actor = actors[who];
    for (let k = 0; k < frames; k++) {
      points.set(numbers.subarray(at(who, k), at(who, k) + 3), 3 * k);
      new THREE.Color(COLOURS[phase(actor, run.begin + k / run.rate)]).toArray(colours, 3 * k);
    }
    curve.geometry.setAttribute('position', new THREE.BufferAttribute(points, 3));
    curve.geometry.setAttribute('color', new THREE.BufferAttribute(colours, 3));
  }

  // ------------------------------------------------------------------------------------------------ time
  const duration = (frames - 1) / run.rate, up = new THREE.Vector3(0, 1, 0);
  let time = 0, playing = true, who = 0;
  const last = new THREE.Vector3(), here = new THREE.Vector3();

  function seek(to) {
    time = Math.min(Math.max(to, 0), duration);
    mixer.setTime(Math.min(time, duration - 1e-4));
    for (const kind of printKinds) {
      const count = kind.contacts.findIndex((contact) => contact > run.begin + time);
      kind.mesh.count = count < 0 ? kind.contacts.length : count;
      kind.mesh.visible = $('prints').checked && kind.mesh.count > 0;
    }
    const frame = Math.min(Math.round(time * run.rate), frames - 1);
    arrows.forEach(({ arrow, shaft, tip }, side) => {
      const k = at(who, frame) + 3 + 6 * side;
      const force = new THREE.Vector3().fromArray(numbers, k + 3), size = FORCE * force.length();
      arrow.visible = $('forces').checked && size > 0.005;
      if (!arrow.visible) return;
      arrow.position.fromArray(numbers, k);
      arrow.quaternion.setFromUnitVectors(up, force.normalize());
      shaft.scale.y = Math.max(size - 0.09, 0.001);
      tip.position.y = shaft.scale.y;
    });
    curve.visible = $('curve').checked;
    $('time').textContent = `${(run.begin + time).toFixed(2)} s of ${(run.begin + duration).toFixed(2)} s, ${phase(actors[who], run.begin + time)} stance`.replace('flight stance', 'flight');
    document.body.dataset.time = time.toFixed(4);
    drawTimeline();
  }

  function look() {  // at whom is followed, from ahead and aside
    here.copy(actors[who].root.position);
    const size = actors[who].leg * (actors.length > 1 ? 1.7 : 1);
    controls.target.copy(here).y -= 0.35 * actors[who].leg;  // above the panel
    camera.position.copy(here).add(new THREE.Vector3(-2.7, 0.75, 2.9).multiplyScalar(size));
    last.copy(here);
  }

  // ------------------------------------------------------------------------------------------------ the timeline
  const line = $('timeline'), pen = line.getContext('2d');
  function drawTimeline() {
    const scale = window.devicePixelRatio || 1, width = line.clientWidth, height = line.clientHeight;
    if (line.width !== Math.round(width * scale)) { line.width = Math.round(width * scale); line.height = Math.round(height * scale); }
    pen.setTransform(scale, 0, 0, scale, 0, 0);
    pen.clearRect(0, 0, width, height);
    pen.fillStyle = '#eef1f0';
    pen.fillRect(0, 0, width, height);
    const x = (t) => ((t - run.begin) / duration) * width, lane = (height - 18) / 2;
    pen.font = '11px system-ui, sans-serif';
    for (const print of actors[who].prints) {
      pen.fillStyle = COLOURS[print.side ? 'right' : 'left'];
      pen.fillRect(x(print.contact), 2 + print.side * lane, Math.max(x(print.leaves) - x(print.contact), 1), lane - 3);
    }
    const step = [0.1, 0.25, 0.5, 1, 2, 5, 10, 30, 60, 300, 600].find((s) => (s / duration) * width > 46) || 3600;
    pen.fillStyle = '#566';
    for (let t = Math.ceil(run.begin / step) * step; t <= run.begin + duration + 1e-9; t += step) {
      pen.fillRect(x(t), height - 16, 1, 4);
      pen.fillText(`${+t.toFixed(2)} s`, Math.min(x(t) + 3, width - 30), height - 4);
    }
    pen.fillStyle = 'rgba(255,255,255,.75)';
    pen.fillRect(2, 3, 30, 13); pen.fillRect(2, 3 + lane, 34, 13);
    pen.fillStyle = '#233';
    pen.fillText('left', 5, 13); pen.fillText('right', 5, 13 + lane);
    pen.fillRect(x(run.begin + time) - 1, 0, 2, height - 14);
    line.setAttribute('aria-valuenow', time.toFixed(2));
  }
  const scrub = (event) => { const box = line.getBoundingClientRect(); seek(((event.clientX - box.left) / box.width) * duration); };
  line.addEventListener('pointerdown', (event) => { play(false); try { line.setPointerCapture(event.pointerId); } catch { /* a made-up pointer */ } scrub(event); });
  line.addEventListener('pointermove', (event) => { if (event.buttons) scrub(event); });

  // ------------------------------------------------------------------------------------------------ what is pressed
  function play(on) {
    playing = on;
    if (on && time >= duration - 1e-6) seek(0);
    $('play').textContent = on ? 'Pause' : 'Play';
  }
  function choose(k) { who = k; layCurve(); seek(time); look(); }
  actors.forEach((actor, k) => $('who').add(new Option(actor.name, k)));
  $('who').onchange = () => choose(+$('who').value);
  $('play').onclick = () => play(!playing);
  for (const id of ['forces', 'prints', 'curve']) $(id).onchange = () => seek(time);
  addEventListener('keydown', (event) => {
    if (event.target.tagName === 'SELECT' || event.target.tagName === 'INPUT') return;
    if (event.code === 'Space' && event.target.id !== 'play') { event.preventDefault(); play(!playing); }
    if (event.code === 'ArrowLeft' || event.code === 'ArrowRight') { play(false); seek(time + (event.code === 'ArrowLeft' ? -1 : 1) / run.rate); }
  });
  function fit() {
    renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    renderer.setSize(innerWidth, innerHeight, false);
    camera.aspect = innerWidth / innerHeight;
    camera.updateProjectionMatrix();
    drawTimeline();
  }
  addEventListener('resize', fit);

  // ------------------------------------------------------------------------------------------------ and on
  document.querySelector('footer').hidden = false;
  $('word').remove();
  const wanted = new URLSearchParams(location.hash.slice(1));  // #t=2.5 begins there, paused
  choose(0);
  if (wanted.has('t')) { play(false); seek(+wanted.get('t') || 0); look(); }
  fit();
  let before = performance.now();
  renderer.setAnimationLoop((now) => {
    const passed = Math.min((now - before) / 1000, 0.25);
    before = now;
    if (playing) {
      if (time >= duration) play(false);
      else seek(time + passed * +$('speed').value);
    }
    here.copy(actors[who].root.position);
    if ($('follow').checked) {
      const moved = here.clone().sub(last);
      controls.target.add(moved);
      camera.position.add(moved);
    }
    last.copy(here);
    controls.update();
    sun.target.position.copy(controls.target);
    sun.position.copy(controls.target).add(new THREE.Vector3(10, 24, 14));
    renderer.render(scene, camera);
    document.body.dataset.frames = 1 + +(document.body.dataset.frames || 0);
  });
  document.body.dataset.ready = 'yes';
})().catch((error) => {
  const word = document.getElementById('word') || document.body.appendChild(document.createElement('p'));
  word.id = 'word';
  word.textContent = `This page needs a browser with WebGL 2, of 2023 or newer: ${error.message || error}`;
  console.error(error);
});
