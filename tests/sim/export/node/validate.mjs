// Khronos' validator on .glb files: prints [errors, warnings, first messages] of each as JSON.
import { readFileSync } from 'fs';
import validator from 'gltf-validator';

const found = [];
for (const path of process.argv.slice(2)) {
  const { issues } = await validator.validateBytes(new Uint8Array(readFileSync(path)), { maxIssues: 20 });
  found.push([issues.numErrors, issues.numWarnings, issues.messages.slice(0, 5).map((m) => `${m.code} ${m.pointer}`)]);
}
console.log(JSON.stringify(found));
