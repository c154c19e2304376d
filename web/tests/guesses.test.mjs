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

test("views of other memory, and of the module's own, are copied whatever is made of them", () => {
  const numbers = Float32Array.from({ length: 56 }, (_, i) => [0, 0, 0, 1, i, 0.5, 0][i % 7]);
  const memory = new WebAssembly.Memory({ initial: 1 }),
    foreign = new Float32Array(memory.buffer, 64, numbers.length);
  foreign.set(numbers);
  // Every array of a module has a view of it, and memory that grows detaches the view while it is read.
  const own = (from) => dq8.floats(from).view,
    grow = () => dq8.floats(1 << 20);
  const joints = Uint16Array.of(0, 1, 1, 0),
    weights = Float32Array.of(1, 1, 1, 1),
    rest = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12];
  for (const of of [() => foreign, () => own(numbers), () => own(numbers).subarray(0)]) {
    assert.deepEqual([...dq8.floats(of()).view], [...numbers]);
    assert.deepEqual([...dq8.motions(of()).view], [...numbers]);
    const locals = dq8.motions(2);
    skeleton.locals(skeleton.clip(of()).sample(0.5), locals);
    const old = of();
    grow();
    if (old !== foreign)
      fails(() => dq8.floats(old), /^source is a view from before memory has grown: take \.view again$/);
    assert.deepEqual(
      [4, 12].map((i) => locals.view[i]),
      [5.5, 9],
    );
  }
  const shared = new Float32Array(memory.buffer, 1024, 4);
  shared.set(weights);
  for (const of of [() => shared, () => own(weights), () => [...weights]]) {
    const given = of(),
      ids = given === shared ? joints : own(joints);
    const skin = dq8.skin({ jointCount: 2, influences: 1, joints: ids, weights: given }),
      [from, posed] = [dq8.floats(rest), dq8.floats(12)];
    skin.pose({ motions: dq8.motions(2), rest: from, posed });
    assert.deepEqual([...posed.view], rest);
  }
  // Joints take so much that memory grows before weights are read.
  const vertices = 1 << 21,
    heavy = dq8.floats(vertices);
  heavy.view.fill(1);
  dq8.skin({ jointCount: 1, influences: 1, joints: new Uint16Array(vertices), weights: heavy.view }).free();
  // What has been copied is nobody else's.
  const copy = dq8.floats(foreign);
  foreign.fill(9);
  memory.grow(1);
  assert.deepEqual([...copy.view], [...numbers]);
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

test("other names for what there is say which to take", () => {
  const skin = dq8.skin({ jointCount: 1, influences: 1, joints: [0], weights: [1] }),
    clip = skeleton.clip(KEYS);
  const robot = robots.robot(readFileSync(new URL("../../robot/robots/arm7.urdf", import.meta.url), "utf8"));
  const told = [
    [() => dq8.multiply(1, 2), /^Dq8 has no multiply: take mul$/],
    [() => dq8.invert, /take inverse$/],
    [() => dq8.slerp(), /take sclerpEach$/],
    [() => dq8.fromMatrices([]), /take fromMatrices of dq8\/gltf$/],
    [() => dq8.gltf(), /take readGltf of dq8\/gltf$/],
    [() => dq8.clip(KEYS), /take skeleton\.clip$/],
    [() => dq8.robot(""), /take robot of dq8\/robots$/],
    [() => skeleton.sample(0), /^Skeleton has no sample: take clip\.sample$/],
    [() => skeleton.update(), /take palette$/],
    [() => skeleton.bones, /take joints$/],
    [() => skin.update(), /^Skin has no update: take pose$/],
    [() => clip.pack(), /take pack of dq8\/pack$/],
    [() => robot.solve(), /^Robot has no solve: take reach$/],
    [() => robot.ik(), /take reach$/],
    [() => robot.forwardKinematics(), /take poses$/],
    [() => robot.jointNames, /take valueNames$/],
  ];
  for (const [call, text] of told) fails(call, text);
  // What is asked about and not taken is no error.
  assert.deepEqual(Object.keys(dq8), []);
  assert.ok("multiply" in dq8 && !Object.hasOwn(skeleton, "update"));
});

test("arrays that are taken for numbers say where those are", () => {
  const numbers = dq8.floats(3),
    told = /its numbers are in \.view$/;
  for (const call of [
    () => numbers[0],
    () => (numbers[0] = 1),
    () => numbers.set([1]),
    () => numbers.fill(0),
    () => [...numbers],
    () => Array.from(numbers),
    () => new Float32Array(numbers),
    () => numbers.buffer,
  ])
    fails(call, told);
});
