// From three.js' `Skeleton` and `AnimationClip`, whose fields are read and whose classes are not
// imported.
import { decompose } from "./rigid.js";
import { TOLERANCE, rig } from "./rig.js";

const PATHS = { quaternion: "rotation", position: "translation", scale: "scale" };
const DISCRETE = 2300;

const named = ({ name }) => (name ? ` (${name})` : "");
const product = (a, b) =>
  Float64Array.from({ length: 16 }, (_, i) =>
    [0, 1, 2, 3].reduce((sum, k) => sum + a[4 * k + (i & 3)] * b[(i & ~3) + k], 0),
  );

/** A track of three.js, which finds its numbers itself, by whatever law it has. */
class ThreeTrack {
  #interpolant;
  constructor(track, width) {
    this.times = track.times;
    this.steps = track.getInterpolation?.() === DISCRETE;
    this.#interpolant = track.createInterpolant(new Float64Array(width));
  }
  at(time, out) {
    const found = this.#interpolant.evaluate(time);
    for (let k = 0; k < out.length; k++) out[k] = found[k];
  }
}

/** The node and the property of a track, as three.js writes them. */
function target(name) {
  const [, bone, node, property] = /^(?:.*[\/:])?(?:.*\.bones\[(.+)\]|(.+?))\.(\w+(?:\[.+\])?)$/.exec(name) ?? [];
  return { who: bone ?? node, property };
}

export function readThree(skeleton, clips = [], options = {}) {
  const { tolerance = TOLERANCE, root, bindMatrix } = options,
    numbers = new Map(),
    nodes = [],
    left = new Set();
  const parts = ({ matrixAutoUpdate, matrix, quaternion: q, position: t, scale: s }, place) => {
    if (matrixAutoUpdate !== false)
      return { rotation: [q.x, q.y, q.z, q.w], translation: [t.x, t.y, t.z], scale: [s.x, s.y, s.z] };
    const made = decompose(matrix.elements, tolerance);
    if (typeof made === "string") throw new Error(`${place}.matrix: ${made}`);
    return { rotation: made.q, translation: made.t, scale: [made.s, made.s, made.s] };
  };
  const number = (object, whose) => {
    if (!object || object === root) return -1;
    if (!numbers.has(object)) {
      const bone = skeleton.bones.indexOf(object),
        place = bone < 0 ? `parent of ${whose}` : `bones[${bone}]`;
      numbers.set(object, nodes.push({}) - 1);
      const node = { name: object.name ?? "", place, ...parts(object, `${place}${named(object)}`) };
      Object.assign(nodes[numbers.get(object)], node, {
        uuid: object.uuid,
        parent: number(object.parent, `${place}${named(object)}`),
      });
    }
    return numbers.get(object);
  };
  const joints = skeleton.bones.map((bone) => number(bone));
  const find = (who) => {
    if (!who) return -1;
    const bone = joints.find((joint) => nodes[joint].name === who || nodes[joint].uuid === who);
    return bone ?? nodes.findIndex(({ name, uuid }) => name === who || uuid === who);
  };
  const read = clips.map((clip, i) => {
    const place = `clips[${i}]${named(clip)}`,
      tracks = new Map();
    clip.tracks.forEach((track) => {
      const { who, property } = target(track.name),
        node = find(who),
        path = PATHS[property];
      if (node < 0) return left.add("what moves no joint");
      if (!path) {
        if (!/^(position|quaternion|scale|rotation)/.test(property)) return left.add(property);
        throw new Error(
          `${place}: ${track.name} moves a part of ${property.split("[")[0]}: ` +
            "only position, quaternion and scale are read",
        );
      }
      if (!tracks.has(node)) tracks.set(node, {});
      tracks.get(node)[path] = new ThreeTrack(track, path === "rotation" ? 4 : 3);
    });
    return { name: clip.name ?? "", place, duration: clip.duration, tracks };
  });
  const bones = joints.length,
    given = skeleton.boneInverses.length;
  if (given !== bones) throw new Error(`skeleton.boneInverses has ${given} matrices for ${bones} bones`);
  const inverse = (k) =>
    bindMatrix ? product(skeleton.boneInverses[k].elements, bindMatrix.elements) : skeleton.boneInverses[k].elements;
  const skin = { name: "", place: "skeleton", joints, inverseBinds: { place: "skeleton.boneInverses", of: inverse } };
  return { ...rig(nodes, [skin], read, options), left: [...left] };
}
