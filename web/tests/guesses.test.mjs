// What users of three.js and gl-matrix try: it works, or the text says what to take.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { before, test } from "node:test";
import load from "../package/dq8.node.js";
import loadRobots from "../package/robots.node.js";

let dq8, robots, skeleton;
const KEYS = Float32Array.from({ length: 28 }, (_, i) => [0, 0, 0, 1, i, 0, 0][i % 7]);
before(async () => {
  [dq8, robots] = await Promise.all([load(), loadRobots()]);
  skeleton = dq8.skeleton([-1, 0]);
});
const fails = (call, text) =>
  assert.throws(call, (error) => {
    assert.match(error.message, text);
    return true;
  });

test("arrays are made of arrays, of handles and of views of the same memory, though it grows", () => {
  const source = dq8.floats(Float32Array.from({ length: 1 << 20 }, (_, i) => i));
  for (const made of [dq8.floats(source), dq8.floats(source.view), dq8.floats(new Set([1, 2, 3]).size)])
    assert.equal(made.view.at(-1), made.length > 3 ? made.length - 1 : 0);
  for (let i = 0; i < 8; i++) assert.equal(dq8.floats(source.view).view[12345], 12345);
  fails(() => dq8.floats([[1, 2]]), /^source\[0\] is no number$/);
  fails(() => dq8.floats([1, "2"]), /^source\[1\] is no number$/);
});

test("one motion is the parent of many", () => {
  const one = dq8.motions([0, 0, 1, 0, 0.5, 0, 0, 0]),
    many = dq8.motions(5),
    [product, wanted] = [dq8.motions(5), dq8.motions(5)],
    each = dq8.motions(5);
  many.view.forEach((_, i, all) => {
    if (i % 8 === 4) all[i] = i / 10;
  });
  for (let i = 0; i < 5; i++) each.view.set(one.view, 8 * i);
  dq8.mul(one, many, product);
  dq8.mul(each, many, wanted);
  assert.deepEqual(product.view, wanted.view);
  fails(() => dq8.mul(one, many, dq8.motions(4)), /where \d+ (is|are) needed/);
});

test("crowds take as many poses as they have, clips of keys a time alone", () => {
  const crowd = skeleton.crowd(4),
    clip = skeleton.clip(KEYS);
  fails(() => crowd.set(dq8.motions(6)), /^poses holds 6 motions where 8 are needed$/);
  crowd.set(dq8.motions(8));
  fails(() => clip.sample(dq8.floats(1), 5), /^clips are of packed clips alone$/);
});

test("links are given by name, and robots have motions", () => {
  const robot = robots.robot(readFileSync(new URL("../../robot/robots/arm7.urdf", import.meta.url), "utf8"));
  const middle = robot.valueLimits.map(([low, high]) => (low + high) / 2),
    [one, other] = [robots.floats(middle), robots.floats(middle)],
    target = robots.motions(1);
  target.view.set([0.2, 0, 0.3], 4);
  assert.deepEqual(robot.reach("hand", target, one), robot.reach(robot.link("hand"), target, other));
  assert.deepEqual(one.view, other.view);
  const columns = robots.floats(6 * robot.rates);
  robot.jacobians("hand", one, columns);
  assert.ok(columns.view.some((x) => x !== 0));
  fails(() => robot.reach("hnd", target, one), /^link is hnd, none of .*hand/);
  fails(() => robot.reach(0.5, target, one), /^link is 0.5, not a whole number$/);
});
