// Parts of arrays: batches of a crowd, which share numbers with the whole and are never read while they are written.
import assert from "node:assert/strict";
import { before, test } from "node:test";
import load from "../package/dq8.node.js";

const JOINTS = 5,
  PEOPLE = 12,
  BATCH = 4;
let dq8, skeleton, keys;
before(async () => {
  dq8 = await load();
  skeleton = dq8.skeleton(Array.from({ length: JOINTS }, (_, joint) => joint - 1));
  keys = Float32Array.from({ length: 3 * JOINTS * 7 }, (_, i) => (i % 7 < 4 ? Math.sin(i) : Math.cos(i)));
});
const fails = (call, text) =>
  assert.throws(call, (error) => {
    assert.match(error.message, text);
    return true;
  });

test("batches of people are all people", () => {
  const walk = skeleton.clip(keys),
    at = dq8.floats(Float32Array.from({ length: PEOPLE }, (_, i) => i / 6)),
    roots = dq8.motions(PEOPLE),
    inverseBinds = dq8.motions(JOINTS);
  roots.view.forEach((_, i, all) => {
    if (i % 8 === 4) all[i] = i;
  });
  const [whole, parts] = [0, 1].map(() => dq8.floats(16 * JOINTS * PEOPLE));
  skeleton.palette(walk.sample(at), { roots, inverseBinds, palette: whole });
  for (let first = 0; first < PEOPLE; first += BATCH) {
    const part = (of, size) => of.subarray(size * first, size * (first + BATCH));
    const options = { roots: part(roots, 8), inverseBinds, palette: part(parts, 16 * JOINTS) };
    skeleton.palette(walk.sample(part(at, 1)), options);
  }
  assert.deepEqual(parts.view, whole.view);
  const [inner, rest] = [parts.subarray(16).subarray(16, 32), parts.subarray(32)];
  assert.deepEqual(inner.view, parts.view.subarray(32, 48));
  assert.equal(rest.length, parts.length - 32);
});

test("parts grow with memory, are freed with the whole, and free nothing", () => {
  const whole = dq8.floats([1, 2, 3, 4]),
    part = whole.subarray(1, 3),
    again = part.subarray(1);
  dq8.floats(1 << 22);
  assert.deepEqual([...part.view, ...again.view], [2, 3, 3]);
  const other = whole.subarray(0);
  other.free();
  fails(() => other.view, /^the array has been freed$/);
  const next = dq8.floats(4);
  next.view.fill(9);
  assert.deepEqual([...whole.view], [1, 2, 3, 4]);
  whole.free();
  for (const gone of [part, again]) {
    fails(() => gone.view, /^the array has been freed$/);
    fails(() => dq8.mul(gone, gone, dq8.motions(1)), /^a has been freed$/);
    fails(() => gone.subarray(), /^the array has been freed$/);
  }
});

test("what is written has none of the numbers that are read", () => {
  const all = dq8.motions(4),
    [front, back, middle] = [all.subarray(0, 16), all.subarray(16), all.subarray(8, 24)];
  dq8.inverse(front, back);
  dq8.mul(front, front, back);
  for (const [from, to] of [
    [front, middle],
    [middle, back],
    [front, all.subarray(0, 16)],
  ]) {
    fails(() => dq8.mul(from, from, to), /^product has numbers of a$/);
    fails(() => dq8.inverse(from, to), /^inverses has numbers of motions$/);
  }
  fails(() => dq8.mul(front, front, front), /^product is the same array as a$/);
  const two = dq8.skeleton([-1, 0]);
  two.localToModel(front);
  fails(() => two.localToModel(front, middle), /^models has numbers of locals$/);
});

test("parts are within the array", () => {
  const numbers = dq8.floats(8);
  assert.equal(numbers.subarray(8).length, 0);
  fails(() => numbers.subarray(0, 9), /^0 to 9 is no part of 8 numbers$/);
  fails(() => numbers.subarray(5, 4), /^5 to 4 is no part of 8 numbers$/);
  fails(() => numbers.subarray(-1), /^begin is -1, not a whole number$/);
  fails(() => numbers.subarray(0, 1.5), /^end is 1.5, not a whole number$/);
});

test("palettes of a crowd are those of its models", () => {
  const locals = dq8.motions(JOINTS * PEOPLE),
    crowd = skeleton.crowd(PEOPLE),
    inverseBinds = dq8.motions(JOINTS);
  skeleton.locals(skeleton.clip(keys).sample(dq8.floats(PEOPLE)), locals);
  inverseBinds.view.forEach((_, i, all) => {
    if (i % 8 === 5) all[i] = i / 9;
  });
  const [palette, wanted] = [0, 1].map(() => dq8.floats(16 * JOINTS * PEOPLE));
  crowd.set(locals);
  crowd.localToModel();
  crowd.palette({ inverseBinds, palette });
  crowd.copyTo(locals);
  skeleton.modelPalette(locals, { inverseBinds, palette: wanted });
  assert.deepEqual(palette.view, wanted.view);
  assert.ok(palette.view.some((x) => x !== 0 && x !== 1));
});
