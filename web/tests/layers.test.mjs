// Layers upon layers, their laws, and locals that leave and come back; beside plain JavaScript on the same input.
import assert from "node:assert/strict";
import { before, test } from "node:test";
import load from "../package/dq8.node.js";
import { fromMatrices } from "../package/gltf.js";
import { FRAMES, INSTANCES, JOINTS, given, parents } from "./given.mjs";

const POSES = INSTANCES * JOINTS,
  BOUND = 2e-6;
let dq8, skeleton, walk, run, inverseBinds;
before(async () => {
  dq8 = await load();
  skeleton = dq8.skeleton(parents);
  [walk, run] = [given.clipA, given.clipB].map((keys) => skeleton.clip(keys));
  inverseBinds = dq8.motions(JOINTS);
  dq8.fromRotationsTranslations(dq8.floats(given.binds), inverseBinds);
});
const floats = (name) => dq8.floats(given[name]);
const fails = (call, text) =>
  assert.throws(call, (error) => {
    assert.match(error.message, text);
    return true;
  });
const near = (found, wanted, bound = BOUND, what = "") => {
  assert.equal(found.length, wanted.length);
  found.forEach((x, i) => assert.ok(Math.abs(x - wanted[i]) <= bound, `${what}[${i}] is ${x}, not ${wanted[i]}`));
};

const unit = (q) => {
  const n = Math.hypot(...q);
  return q.map((x) => x / n);
};
const multiply = ([a, b, c, d], [x, y, z, w]) => [
  d * x + a * w + b * z - c * y,
  d * y + b * w + c * x - a * z,
  d * z + c * w + a * y - b * x,
  d * w - a * x - b * y - c * z,
];
const LAWS = {
  nlerp: (a, b, t, sign) => unit(a.map((x, k) => (1 - t) * x + sign * t * b[k])),
  slerp: (a, b, t, sign) => {
    const angle = Math.acos(Math.min(1, sign * a.reduce((sum, x, k) => sum + x * b[k], 0))),
      sine = Math.sin(angle);
    return a.map((x, k) => (Math.sin((1 - t) * angle) * x + sign * Math.sin(t * angle) * b[k]) / sine);
  },
};
const between = (a, b, t, law = "nlerp") => {
  const [p, q] = [a.slice(0, 4), b.slice(0, 4)],
    sign = p.reduce((sum, x, k) => sum + x * q[k], 0) < 0 ? -1 : 1;
  return [...LAWS[law](p, q, t, sign), ...a.slice(4).map((x, k) => (1 - t) * x + t * b[4 + k])];
};
const added = (a, b, t) => {
  const sign = b[3] < 0 ? -1 : 1,
    turn = LAWS.nlerp([0, 0, 0, 1], b.slice(0, 4), t, sign);
  return [...multiply(turn, a.slice(0, 4)), ...a.slice(4).map((x, k) => x + t * b[4 + k])];
};
/** [x y z w tx ty tz] of a joint of a clip at a time. */
const sampled = (keys, at, joint) => {
  const held = Math.min(Math.max(at, 0), FRAMES - 1),
    frame = Math.min(Math.floor(held), FRAMES - 2);
  const key = (f) => Array.from(keys.subarray(7 * (f * JOINTS + joint), 7 * (f * JOINTS + joint) + 7));
  return between(key(frame), key(frame + 1), held - frame);
};
/** Poses of all joints of all instances by `pose(instance, joint)`, a quaternion with either sign. */
const compared = (source, pose, bound = BOUND) => {
  const locals = dq8.motions(POSES),
    found = dq8.floats(7 * POSES);
  skeleton.locals(source, locals);
  dq8.toRotationsTranslations(locals, found);
  for (let i = 0; i < POSES; i++) {
    const own = Array.from(found.view.subarray(7 * i, 7 * i + 7)),
      wanted = pose(Math.floor(i / JOINTS), i % JOINTS);
    const sign = own.slice(0, 4).reduce((sum, x, k) => sum + x * wanted[k], 0) < 0 ? -1 : 1;
    near(
      own.map((x, k) => (k < 4 ? sign * x : x)),
      wanted,
      bound,
      `pose ${i}`,
    );
  }
  locals.free();
  found.free();
};

test("walk, run, aim and a mask are one source, as deep as one likes, on either side", () => {
  const [atA, atB, weights, mask, locals] = [...["atA", "atB", "weights", "mask"].map(floats), dq8.motions(POSES)];
  dq8.fromRotationsTranslations(floats("locals"), locals);
  const [a, b] = [walk.sample(atA), run.sample(atB)],
    stored = (i, j) => Array.from(given.locals.subarray(7 * (JOINTS * i + j), 7 * (JOINTS * i + j) + 7));
  const at = { a: (i, j) => sampled(given.clipA, given.atA[i], j), b: (i, j) => sampled(given.clipB, given.atB[i], j) };
  const w = (i) => given.weights[i],
    m = (i, j) => given.weights[i] * given.mask[j];
  const both = a.blend(b, weights),
    wanted = (i, j) => between(at.a(i, j), at.b(i, j), w(i));
  compared(both.add(a, weights, { mask }), (i, j) => added(wanted(i, j), at.a(i, j), m(i, j)), 1e-5);
  compared(b.blend(both, weights, { mask }), (i, j) => between(at.b(i, j), wanted(i, j), m(i, j)), 1e-5);
  compared(both.blend(dq8.poses(locals), weights), (i, j) => between(wanted(i, j), stored(i, j), w(i)), 1e-5);
  // Layers on both sides, three deep.
  const deep = both.add(a, weights).blend(b.blend(dq8.poses(locals), weights).blend(both, 0.25), weights, { mask });
  compared(
    deep,
    (i, j) => {
      const one = added(wanted(i, j), at.a(i, j), w(i)),
        other = between(between(at.b(i, j), stored(i, j), w(i)), wanted(i, j), 0.25);
      return between(one, other, m(i, j));
    },
    3e-5,
  );
});

test("slerp turns at a constant speed where it is asked for, nlerp where nothing is", () => {
  const [atA, atB, weights] = ["atA", "atB", "weights"].map(floats),
    [a, b] = [walk.sample(atA), run.sample(atB)];
  const wanted = (law) => (i, j) =>
    between(sampled(given.clipA, given.atA[i], j), sampled(given.clipB, given.atB[i], j), given.weights[i], law);
  compared(a.blend(b, weights, { law: "slerp" }), wanted("slerp"), 1e-5);
  compared(a.blend(b, weights, { law: "nlerp" }), wanted("nlerp"));
  compared(a.blend(b, weights), wanted("nlerp"));
  assert.throws(() => compared(a.blend(b, weights), wanted("slerp"), 1e-3), /pose/, "the laws differ");
  fails(() => a.blend(b, weights, { law: "lerp" }), /^law is lerp, none of nlerp, slerp$/);
});

test("a number stands for all instances, and one root", () => {
  const [same, times] = [0.25, 1.75].map((x) => dq8.floats(new Float32Array(INSTANCES).fill(x))),
    root = dq8.motions(1);
  dq8.fromRotationsTranslations(dq8.floats(given.roots.slice(0, 7)), root);
  const roots = dq8.motions(INSTANCES),
    [one, other] = [dq8.motions(POSES), dq8.motions(POSES)];
  for (let i = 0; i < INSTANCES; i++) roots.view.set(root.view, 8 * i);
  skeleton.localToModel(walk.sample(times).blend(run.sample(times), same), one, { roots });
  skeleton.localToModel(walk.sample(1.75).blend(run.sample(1.75), 0.25), other, { roots: root });
  assert.deepEqual(other.view, one.view);
  const alone = dq8.motions(JOINTS);
  skeleton.localToModel(walk.sample(1.75), alone);
  skeleton.localToModel(walk.sample(times), one);
  assert.deepEqual(alone.view, one.view.slice(0, 8 * JOINTS));
});

test("locals of a sampled pose leave, are changed and come back; models become locals", () => {
  const [atA, atB, weights] = ["atA", "atB", "weights"].map(floats),
    roots = dq8.motions(INSTANCES),
    source = walk.sample(atA).blend(run.sample(atB), weights);
  dq8.fromRotationsTranslations(floats("roots"), roots);
  const [locals, models, back] = [0, 0, 0].map(() => dq8.motions(POSES)),
    [one, other] = [0, 0].map(() => dq8.floats(16 * POSES));
  skeleton.locals(source, locals);
  skeleton.palette(source, { roots, inverseBinds, palette: one });
  skeleton.palette(locals, { roots, inverseBinds, palette: other });
  near(other.view, one.view, 2e-5);
  skeleton.localToModel(locals, models, { roots });
  skeleton.modelToLocal(models, back, { roots });
  near(back.view, locals.view, 2e-5);
  // A head that is turned takes along what hangs from it.
  const child = parents.indexOf(1);
  locals.view.set([0, 0, 0, 1, 0, 0, 0, 0], 8);
  skeleton.localToModel(locals, back, { roots });
  assert.ok(back.view.slice(8 * child, 8 * child + 8).some((x, k) => Math.abs(x - models.view[8 * child + k]) > 1e-3));
  fails(() => skeleton.locals(locals, models), /^source is neither a sample/);
  fails(() => skeleton.modelToLocal(models, back, { roots: back }), /^locals is the same array as roots$/);
});

test("one motion moves many points; motions are inverted, taken apart and made of matrices", () => {
  const [count, poses] = [JOINTS * INSTANCES, floats("locals")],
    motions = dq8.motions(POSES),
    points = dq8.floats(given.points);
  dq8.fromRotationsTranslations(poses, motions);
  const one = dq8.motions(motions.view.slice(0, 8)),
    each = dq8.motions(count),
    [moved, wanted] = [dq8.floats(3 * count), dq8.floats(3 * count)];
  for (let i = 0; i < count; i++) each.view.set(one.view, 8 * i);
  dq8.transformPoints(one, points, moved);
  dq8.transformPointsEach(each, points, wanted);
  near(moved.view, wanted.view);
  fails(() => dq8.transformPoints(motions, points, moved), /^motion holds \d+ motions where 1 is needed$/);
  const [back, product, still] = [0, 0, 0].map(() => dq8.motions(POSES));
  dq8.inverse(motions, back);
  dq8.mul(motions, back, product);
  near(product.view, still.view);
  const matrices = dq8.floats(16 * POSES),
    again = dq8.motions(POSES),
    apart = dq8.floats(7 * POSES);
  dq8.toRotationsTranslations(motions, apart);
  near(apart.view, given.locals);
  dq8.matrices(motions, matrices);
  again.view.set(fromMatrices(matrices.view));
  const sign = (i) =>
    Math.sign([0, 1, 2, 3].reduce((sum, k) => sum + again.view[8 * i + k] * motions.view[8 * i + k], 0));
  near(
    again.view.map((x, i) => sign(i >> 3) * x),
    motions.view,
  );
  const scaled = Array.from(matrices.view.subarray(0, 32), (x, i) => (i > 15 && i % 16 < 12 ? 2 * x : x));
  fails(() => fromMatrices(scaled), /^matrices\[1\] scales by 2/);
  fails(() => fromMatrices(scaled.slice(1)), /^matrices holds 31 numbers, which is not a multiple of 16$/);
});

test("an array that is taken for its numbers says where they are", () => {
  const handle = dq8.floats([1, 2]),
    text = /^an array of dq8 has no .*: its numbers are in \.view$/;
  for (const call of [
    () => handle[0],
    () => {
      handle[0] = 1;
    },
    () => Array.from(handle),
    () => [...handle],
    () => new Float32Array(handle),
    () => handle.fill(0),
    () => handle.buffer,
  ])
    fails(call, text);
  handle.name = "mine";
  assert.deepEqual(
    [handle.name, handle.length, handle.nothing, String(handle), [...handle.view]],
    ["mine", 2, undefined, "[object Object]", [1, 2]],
  );
  assert.deepEqual([walk.frames, walk.duration], [FRAMES, FRAMES - 1]);
});

test("errors of layers name what is wrong, and write nothing", async () => {
  const [at, weights] = ["atA", "weights"].map(floats),
    models = dq8.motions(POSES),
    before = models.view.slice(),
    source = walk.sample(at).blend(run.sample(at), weights).add(walk.sample(at), weights);
  const into =
    (made, to = models) =>
    () =>
      skeleton.localToModel(made, to);
  fails(() => walk.sample(at).blend(run, weights), /^layer is neither a sample nor dq8.poses$/);
  fails(into(source.blend(dq8.poses(dq8.motions(3)), weights)), /^layer\.locals holds 3 motions where \d+ are needed$/);
  fails(into(source.blend(walk.sample(dq8.floats(3)), weights)), /^layer holds/);
  fails(into(source.blend(walk.sample(at), dq8.floats(3))), /^weights holds/);
  fails(into(source.blend(walk.sample(at), at, { mask: at })), /^mask holds/);
  fails(into(source.blend(dq8.poses(models), weights)), /^models is the same array as layer\.locals$/);
  fails(into(source.blend(walk.sample([1]), weights)), /^layer\.at is no array of dq8\.floats$/);
  const other = await load();
  fails(into(source.blend(other.poses(other.motions(POSES)), weights)), /^locals is of another module$/);
  fails(() => skeleton.locals(source, dq8.floats(9)), /^locals holds 9 numbers/);
  const gone = skeleton.clip(given.clipA),
    over = source.blend(gone.sample(at), weights);
  gone.free();
  fails(into(over), /freed/);
  assert.deepEqual(models.view, before);
  fails(() => dq8.skeleton([-1, 2 ** 32]), /^parents\[1\] is 4294967296/);
  for (const bad of [0, NaN])
    fails(
      () => skeleton.clip(given.clipA.map((x, i) => (i >= 7 && i < 11 ? bad : x))),
      /^keys\[7\] of frame 0, joint 1 begins no pose$/,
    );
});

test("layers of a frame take no memory after the first", () => {
  const [at, weights] = ["atA", "weights"].map(floats),
    palette = dq8.floats(16 * POSES);
  const frame = () =>
    skeleton.palette(walk.sample(at).blend(run.sample(1), 0.5).add(walk.sample(at), weights, { mask: null }), {
      inverseBinds,
      palette,
    });
  frame();
  const { buffer } = palette.view,
    bytes = buffer.byteLength;
  for (let i = 0; i < 2000; i++) frame();
  assert.equal(palette.view.buffer.byteLength, bytes);
});
