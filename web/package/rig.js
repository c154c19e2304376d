// From nodes, tracks and matrices, as glTF and three.js have them, to what `dq8` takes: a skeleton
// of rigid joints, keys at a rate, inverse binds. A constant uniform scale is folded: into
// translations, and into the size of the mesh.
import { fail } from "./accessors.js";
import { Local, resample } from "./resample.js";
import { decompose, short, uniform, writeMotion } from "./rigid.js";

/** How far a scale may be from the scale that is folded, relative to it. */
export const TOLERANCE = 1e-3;
/** The place of a node with its name, as errors have it. */
const placed = (node) => ({ ...node, place: node.name ? `${node.place} (${node.name})` : node.place });

/**
 * Joints and all that they hang from, parents first; without ancestors of joints between them, in
 * the order of the joints.
 */
function ordered(nodes, skins) {
  const order = new Set(),
    open = new Set();
  const visit = (index, whose) => {
    if (order.has(index)) return;
    const node = nodes[index] ?? fail(whose, `there is no node ${index}`);
    if (open.has(index)) fail(node.place, "is its own ancestor");
    open.add(index);
    if (node.parent >= 0) visit(node.parent, node.place);
    open.delete(index);
    order.add(index);
  };
  for (const skin of skins) for (const joint of skin.joints) visit(joint, skin.place);
  return [...order];
}

/** The scale of a node, which no clip may change. */
function scaleOf(node, tracks, tolerance) {
  const s = uniform(node.scale, tolerance);
  if (Number.isNaN(s))
    fail(node.place, `scale is ${node.scale.map(short).join(", ")}: only a uniform scale other than 0 is rigid`);
  for (const [clip, track] of tracks) {
    const now = [0, 0, 0];
    // Between keys too, where a cubic spline may leave its keys.
    for (let i = 0; i < track.times.length; i++)
      for (const part of [0, 0.25, 0.5, 0.75]) {
        const time = track.times[i] + part * ((track.times[i + 1] ?? track.times[i]) - track.times[i]);
        track.at(time, now);
        if (now.every((x) => Math.abs(x - s) <= tolerance * Math.abs(s))) continue;
        fail(
          clip.place,
          `scale of ${node.place} is ${now.map(short).join(", ")} at ${short(time)} s, and ${short(s)} at rest: ` +
            "only a constant scale can be folded away",
        );
      }
  }
  return s;
}

/**
 * Inverse binds as motions of all joints, and what the mesh must be multiplied by before they move
 * it.
 */
function bound(skin, nodes, joint, scale, { tolerance }) {
  const inverseBinds = new Float32Array(8 * joint.count).map((_, i) => (i % 8 === 3 ? 1 : 0));
  let size;
  skin.joints.forEach((index, k) => {
    const where = `${skin.inverseBinds.place}[${k}], of ${nodes[index].place}`,
      made = decompose(skin.inverseBinds.of(k), tolerance);
    if (typeof made === "string") fail(where, made);
    const s = scale.get(index),
      whole = made.s * s;
    size ??= Math.abs(whole - 1) < 1e-5 ? 1 : whole;
    if (!(Math.abs(whole - size) <= tolerance * Math.abs(size))) {
      fail(
        where,
        `makes the mesh ${short(whole)} times as large, and the first joint ${short(size)} times: ` +
          "only one scale can be folded away",
      );
    }
    writeMotion(
      made.q,
      made.t.map((x) => s * x),
      inverseBinds,
      8 * joint.of.get(index),
    );
  });
  return {
    name: skin.name,
    joints: Uint16Array.from(skin.joints, (index) => joint.of.get(index)),
    inverseBinds,
    scale: size ?? 1,
  };
}

/**
 * `nodes` have { name, place, parent, rotation, translation, scale }, `skins` { name, place,
 * joints, inverseBinds: { place, of } }, `clips` { name, place, duration, tracks: Map of node to {
 * rotation, translation, scale } }.
 */
export function rig(given, skins, clips, options = {}) {
  const { rate = 30, tolerance = TOLERANCE } = options,
    chosen = { rate, tolerance },
    nodes = given.map(placed);
  for (const name of ["rate", "tolerance"])
    if (!(chosen[name] > 0 && chosen[name] < Infinity))
      throw new RangeError(`${name} is ${chosen[name]}, not a positive number`);
  const order = ordered(nodes, skins),
    joints = new Set(skins.flatMap((skin) => [...skin.joints]));
  if (joints.size > 65536) throw new RangeError(`there are ${joints.size} joints, and indices have 16 bits`);
  const moving = new Set(
    clips.flatMap(({ tracks }) =>
      [...tracks].filter(([, { rotation, translation }]) => rotation || translation).map(([index]) => index),
    ),
  );
  const kept = order.filter((index) => joints.has(index) || moving.has(index)),
    of = new Map(kept.map((index, joint) => [index, joint]));
  // Of each node: its scale with those above it, what is fixed between its children and the joint
  // above them, and itself.
  const scale = new Map(),
    above = new Map(),
    parent = new Map(),
    rest = new Map(),
    make = new Map();
  for (const index of order) {
    const node = nodes[index],
      size = scale.get(node.parent) ?? 1,
      fixed = above.get(node.parent),
      own = new Float64Array(7);
    const tracks = clips.flatMap((clip) => {
      const track = clip.tracks.get(index)?.scale;
      return track ? [[clip, track]] : [];
    });
    scale.set(index, size * scaleOf(node, tracks, chosen.tolerance));
    make.set(index, (clip) => new Local(node, fixed, size, clip?.tracks.get(index), clip ? `${clip.place}: ` : ""));
    make.get(index)().at(0, 0, own);
    rest.set(index, own);
    if (!of.has(index)) above.set(index, own);
    parent.set(index, node.parent < 0 ? -1 : (of.get(node.parent) ?? parent.get(node.parent)));
  }
  return {
    parents: Int32Array.from(kept, (index) => parent.get(index)),
    names: kept.map((index) => nodes[index].name),
    rest: Float32Array.from(kept.flatMap((index) => Array.from(rest.get(index)))),
    clips: clips.map((clip) =>
      resample(
        clip,
        kept.map((index) => make.get(index)(clip)),
        chosen.rate,
        options.error ?? true,
      ),
    ),
    skins: skins.map((skin) => bound(skin, nodes, { of, count: kept.length }, scale, chosen)),
  };
}
