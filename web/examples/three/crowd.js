// Many of one skinned mesh of three.js in one draw: dq8 makes their palettes, and a texture has them.
import * as THREE from "three";
import { readThree } from "dq8/gltf";

const SKIN = `
  mat4 skin = mat4(0.0);
  for (int i = 0; i < 4; i++) {
    ivec2 at = ivec2(4 * int(joints[i]), gl_InstanceID);
    skin += weights[i] * mat4(texelFetch(palettes, at, 0), texelFetch(palettes, at + ivec2(1, 0), 0),
      texelFetch(palettes, at + ivec2(2, 0), 0), texelFetch(palettes, at + ivec2(3, 0), 0));
  }
  vec3 objectNormal = mat3(skin) * normal;`;

/** So many of `mesh`, which moves by the first two of `clips` in the space of `root`. */
export function crowd(dq8, { mesh, clips, root, people, rate = 60 }) {
  const { geometry, skeleton: bones, bindMatrix } = mesh;
  const rig = readThree(bones, clips, { root, bindMatrix, rate }), [skin] = rig.skins, joints = rig.parents.length;
  const skeleton = dq8.skeleton(rig.parents), inverseBinds = dq8.motions(skin.inverseBinds);
  const [one, other] = rig.clips.map(({ keys, rate }) => skeleton.clip(keys, { rate, loops: true }));
  const [times, otherTimes, weights] = [0, 0, 0].map(() => dq8.floats(people)), roots = dq8.motions(people);
  const palette = dq8.floats(16 * joints * people);

  const texture = new THREE.DataTexture(palette.view, 4 * joints, people, THREE.RGBAFormat, THREE.FloatType);
  const instances = new THREE.InstancedBufferGeometry();
  const { position, normal, skinIndex, skinWeight } = geometry.attributes;
  const moved = Uint16Array.from({ length: 4 * skinIndex.count }, (_, i) => skin.joints[skinIndex.getComponent(i >> 2, i & 3)]);
  instances.setIndex(geometry.index).setAttribute("position", position.clone());
  instances.setAttribute("normal", normal.clone());
  instances.setAttribute("joints", new THREE.BufferAttribute(moved, 4)).setAttribute("weights", skinWeight);
  instances.instanceCount = people;
  if (skin.scale !== 1) instances.scale(skin.scale, skin.scale, skin.scale);

  const material = mesh.material.clone();
  material.onBeforeCompile = (shader) => {
    shader.uniforms.palettes = { value: texture };
    shader.vertexShader = shader.vertexShader
      .replace("#include <common>", "#include <common>\nuniform highp sampler2D palettes; attribute vec4 joints, weights;")
      .replace("#include <beginnormal_vertex>", SKIN)
      .replace("#include <begin_vertex>", "vec3 transformed = (skin * vec4(position, 1.0)).xyz;");
  };
  const drawn = new THREE.Mesh(instances, material);
  drawn.frustumCulled = false;
  return {
    mesh: drawn, rig, joints, times, otherTimes, weights, roots, palette,
    /** The palettes of all, by slerp as three.js blends. */
    update() {
      const poses = one.sample(times).blend(other.sample(otherTimes), weights, { law: "slerp" });
      skeleton.palette(poses, { roots, inverseBinds, palette });
      texture.image.data = palette.view;
      texture.needsUpdate = true;
    },
  };
}
