// A thousand of them, and the first beside three.js' own.
import * as THREE from "three";
import load from "dq8";
import { character } from "./character.js";
import { crowd } from "./crowd.js";

const PEOPLE = 1000, ACROSS = 40;
const dq8 = await load(), { root, mesh, clips } = character();
const many = crowd(dq8, { mesh, clips, root, people: PEOPLE });
const renderer = new THREE.WebGLRenderer({ antialias: true }), scene = new THREE.Scene();
const camera = new THREE.PerspectiveCamera(45, innerWidth / innerHeight, 0.1, 100);
camera.position.set(0, 6, 18);
camera.lookAt(0, 0, 0);
scene.background = new THREE.Color(0xf4f1ea);
scene.add(many.mesh, new THREE.HemisphereLight(0xffffff, 0x886644, 3));
renderer.setSize(innerWidth, innerHeight);
document.body.append(renderer.domElement);

for (let i = 0; i < PEOPLE; i++) {
  const x = (i % ACROSS - ACROSS / 2) / 2, z = (Math.floor(i / ACROSS) - PEOPLE / ACROSS / 2) / 1.5;
  many.roots.view.set([x / 2, 0, z / 2], 8 * i + 4);   // a motion: half of the translation is its dual part
  many.weights.view[i] = (i * 0.618) % 1;
}
function pose(seconds) {
  for (let i = 0; i < PEOPLE; i++) many.times.view[i] = many.otherTimes.view[i] = seconds + (i * 0.137) % 3;
  many.update();
}
renderer.setAnimationLoop((milliseconds) => { pose(milliseconds / 1000); renderer.render(scene, camera); });

/** Three.js' own bones of one of them. */
function own(person) {
  const mixer = new THREE.AnimationMixer(root), weight = many.weights.view[person];
  clips.forEach((clip, i) => mixer.clipAction(clip).setEffectiveWeight(i ? weight : 1 - weight).play());
  mixer.setTime(many.times.view[person]);
  root.position.fromArray(many.roots.view, 8 * person + 4).multiplyScalar(2);
  root.updateMatrixWorld(true);
  mesh.skeleton.update();
  return mesh.skeleton.boneMatrices;
}
/** The largest difference from three.js' palettes, of all people, as a share of how far away they stand. */
window.difference = (seconds) => {
  pose(seconds);
  let most = 0;
  for (let i = 0; i < PEOPLE; i++) own(i).forEach((x, k) => {
    const gap = Math.abs(x - many.palette.view[16 * many.joints * i + k]);
    most = Math.max(most, gap / Math.max(1, root.position.length()));
  });
  return most;
};
/** Pixels that differ when three.js draws one of them, and how many it covers. */
window.pixels = (person, seconds) => {
  const size = 256, target = new THREE.WebGLRenderTarget(size, size), near = new THREE.PerspectiveCamera(30, 1, 0.1, 100);
  pose(seconds);
  own(person);
  near.position.copy(root.position).add(new THREE.Vector3(1, 2, 5));
  near.lookAt(root.position.x, 1, root.position.z);
  // The first in the texture is the one that is drawn.
  const first = 16 * many.joints;
  many.palette.view.copyWithin(0, first * person, first * (person + 1));
  many.mesh.geometry.instanceCount = 1;
  const [a, b] = [many.mesh, root].map((shown) => {
    scene.remove(many.mesh, root);
    scene.add(shown);
    renderer.setRenderTarget(target);
    renderer.render(scene, near);
    const found = new Uint8Array(4 * size * size);
    renderer.readRenderTargetPixels(target, 0, 0, size, size, found);
    return found;
  });
  renderer.setRenderTarget(null);
  scene.remove(root);
  scene.add(many.mesh);
  many.mesh.geometry.instanceCount = PEOPLE;
  let differ = 0, covered = 0;
  for (let i = 0; i < a.length; i += 4) {
    differ += +[0, 1, 2].some((k) => Math.abs(a[i + k] - b[i + k]) > 8);
    covered += +[0, 1, 2].some((k) => Math.abs(a[i + k] - a[k]) > 8);
  }
  return { differ, covered };
};
window.ready = true;
