// A character without a file: a stalk of bones in a tube, which nods and sways. GLTFLoader gives the same objects.
import * as THREE from "three";

const BONES = 8, LENGTH = 0.25;

function clip(name, seconds, turn) {
  const times = Array.from({ length: 31 }, (_, i) => seconds * i / 30), q = new THREE.Quaternion();
  return new THREE.AnimationClip(name, seconds, Array.from({ length: BONES }, (_, bone) => {
    const values = times.flatMap((time) => turn(q, bone, 2 * Math.PI * time / seconds).toArray());
    return new THREE.QuaternionKeyframeTrack(`bone${bone}.quaternion`, times, values);
  }));
}

export function character() {
  const height = BONES * LENGTH, geometry = new THREE.CylinderGeometry(0.12, 0.16, height, 12, 4 * BONES).translate(0, height / 2, 0);
  const { position } = geometry.attributes, indices = [], weights = [];
  for (let v = 0; v < position.count; v++) {
    const at = Math.min(position.getY(v) / LENGTH, BONES - 1e-6), bone = Math.floor(at), part = at - bone;
    indices.push(bone, Math.min(bone + 1, BONES - 1), 0, 0);
    weights.push(1 - part, part, 0, 0);
  }
  geometry.setAttribute("skinIndex", new THREE.Uint16BufferAttribute(indices, 4));
  geometry.setAttribute("skinWeight", new THREE.Float32BufferAttribute(weights, 4));
  const bones = Array.from({ length: BONES }, (_, bone) => Object.assign(new THREE.Bone(), { name: `bone${bone}` }));
  bones.forEach((bone, i) => { if (i) { bone.position.y = LENGTH; bones[i - 1].add(bone); } });
  const mesh = new THREE.SkinnedMesh(geometry, new THREE.MeshStandardMaterial({ color: 0x4477aa })), root = new THREE.Group();
  mesh.frustumCulled = false;
  root.add(bones[0], mesh);
  root.updateMatrixWorld(true);
  mesh.bind(new THREE.Skeleton(bones));
  const x = new THREE.Vector3(1, 0, 0), z = new THREE.Vector3(0, 0, 1);
  const clips = [
    clip("nod", 1, (q, bone, phase) => q.setFromAxisAngle(x, 0.15 * Math.sin(phase - bone))),
    clip("sway", 1.5, (q, bone, phase) => q.setFromAxisAngle(z, 0.2 * Math.sin(phase - bone / 2))),
  ];
  return { root, mesh, clips };
}
