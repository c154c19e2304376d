// Packing: what is packed plays as its keys do, within what the declarations say, in a quarter of the bytes; keys that
// no packed clip holds are told with their place. `package.test.mjs` has the bytes that Rust writes.
import assert from "node:assert/strict";
import { before, test } from "node:test";
import load from "../package/dq8.node.js";
import loadPacker, { PackError, compile } from "../package/pack.node.js";

const JOINTS = 3,
  FRAMES = 40;
/** The first joint walks four units, the second turns, the third keeps still. */
const KEYS = Float32Array.from({ length: 7 * JOINTS * FRAMES }, (_, i) => {
  const [frame, joint, c] = [Math.floor(i / 7 / JOINTS), Math.floor(i / 7) % JOINTS, i % 7];
  const half = joint === 1 ? 0.4 * Math.sin(0.3 * frame) : 0;
  if (c < 4) return [0, Math.sin(half), 0, Math.cos(half)][c];
  return c === 4 && joint === 0 ? (4 * frame) / (FRAMES - 1) : 0.25;
});
/** Of a rotation, in radians, and of a translation along a side of four units. */
const [ANGLE, LENGTH] = [4e-5, 4 / 131068 + 1e-7];

let dq8, packer;
before(async () => {
  [dq8, packer] = await Promise.all([load(), loadPacker()]);
});
const fails = (call, name, text) => {
  let found;
  assert.throws(call, (error) => {
    assert.equal(error.name, name);
    assert.match(error.message, text);
    found = error;
    return true;
  });
  return found;
};
const changed = (at, value) => {
  const keys = KEYS.slice();
  keys[at] = value;
  return [{ keys: KEYS }, { keys }];
};

test("packed clips play as their keys do, within the bounds, in a quarter of the bytes", () => {
  const skeleton = dq8.skeleton([-1, 0, 1]),
    at = dq8.floats(Float32Array.from({ length: FRAMES }, (_, frame) => frame / 30));
  const bytes = packer.pack(JOINTS, [{ keys: KEYS, rate: 30 }, { keys: [...KEYS], rate: 30, loops: true }]);
  const library = dq8.packedClip(bytes);
  // Two of six tracks move.
  assert.ok(bytes.length < 2 * (8 * (2 * FRAMES + 3) + 128), `${bytes.length} bytes`);
  assert.deepEqual([library.clips, library.frames(0), library.frames(1)], [2, FRAMES, FRAMES]);
  assert.ok(Math.abs(library.duration(1) - (FRAMES - 1) / 30) < 1e-6);
  const [plain, packed, one, two] = [0, 0, 0, 0].map(() => dq8.motions(JOINTS * FRAMES)),
    poses = [plain, packed].map(() => dq8.floats(7 * JOINTS * FRAMES));
  skeleton.locals(skeleton.clip(KEYS, { rate: 30 }).sample(at), plain);
  skeleton.locals(library.sample(at), packed);
  [plain, packed].forEach((motions, i) => dq8.toRotationsTranslations(motions, poses[i]));
  const [wanted, got] = poses.map(({ view }) => view);
  for (let i = 0; i < wanted.length; i += 7) {
    const chord = Math.hypot(...[0, 1, 2, 3].map((c) => wanted[i + c] - got[i + c]));
    assert.ok(2 * chord <= ANGLE, `${2 * chord} radians at ${i}`);
    for (let c = 4; c < 7; c++) assert.ok(Math.abs(wanted[i + c] - got[i + c]) <= LENGTH, `${wanted[i + c]} at ${i}`);
  }
  // The second loops, the first is held at its end.
  const late = dq8.floats([(FRAMES - 1 + 5.5) / 30]);
  const ends = [one, two].map((to) => to.subarray(0, 8 * JOINTS));
  skeleton.locals(library.sample(late, 1), ends[0]);
  skeleton.locals(library.sample(5.5 / 30, 1), ends[1]);
  ends[0].view.forEach((x, i) => assert.ok(Math.abs(x - ends[1].view[i]) < 1e-4));
  skeleton.locals(library.sample(late, 0), ends[0]);
  assert.ok(Math.abs(ends[0].view[4] - 2) < 1e-3);
});

test("wider limits keep more tracks as one key", () => {
  const size = (limits) => packer.pack(JOINTS, [{ keys: KEYS }], limits).length;
  const [all, turns, none] = [size({}), size({ length: 5 }), size({ length: 5, angle: 2 })];
  assert.deepEqual([all - turns, turns - none], [8 * FRAMES, 8 * (FRAMES - 1)]);
});

test("keys that no packed clip holds are told with clip, frame and joint", () => {
  const at = 7 * (5 * JOINTS + 1);
  const pack = (clips) => () => packer.pack(JOINTS, clips);
  const told = fails(pack(changed(at + 3, 0.25)), "PackError", /^joint 1 in frame 5 of clip 1 has a /);
  assert.ok(told instanceof PackError && told.value < 0.9 && told.value > 0.25);
  assert.deepEqual([told.clip, told.frame, told.joint], [1, 5, 1]);
  assert.ok(Number.isNaN(fails(pack(changed(at, NaN)), "PackError", /length NaN/).value));
  const far = fails(pack(changed(at + 4, Infinity)), "PackError", /^joint 1 in frame 5 of clip 1 is at Infinity/);
  assert.deepEqual([far.clip, far.frame, far.joint, far.value], [1, 5, 1, Infinity]);
  const slow = fails(pack([{ keys: KEYS, rate: 1e-60 }]), "PackError", /^clip 0 has 1e-60 frames/);
  assert.deepEqual([slow.clip, slow.frame, slow.value], [0, undefined, 1e-60]);
  // More tracks than 15 bits count, and no clip is at fault.
  const wide = new Float32Array(7 * 32769);
  for (let i = 3; i < wide.length; i += 7) wide[i] = 1;
  const large = fails(() => packer.pack(32769, [{ keys: wide }]), "PackError", /more tracks than 15 bits/);
  assert.deepEqual([large.clip, large.value], [undefined, undefined]);
  // After errors as before.
  assert.equal(dq8.packedClip(packer.pack(JOINTS, [{ keys: KEYS }])).clips, 1);
});

test("wrong arguments are named", () => {
  const clips = [{ keys: KEYS }];
  for (const [call, name, text] of [
    [() => packer.pack(), "TypeError", /^joints is missing$/],
    [() => packer.pack(0, clips), "RangeError", /^joints is 0/],
    [() => packer.pack(1.5, clips), "RangeError", /^joints is 1.5, not a whole number$/],
    [() => packer.pack(JOINTS), "TypeError", /^clips is missing$/],
    [() => packer.pack(JOINTS, KEYS), "TypeError", /^clips is no array$/],
    [() => packer.pack(JOINTS, []), "RangeError", /^clips is empty$/],
    [() => packer.pack(JOINTS, [{}]), "TypeError", /^clips\[0\]\.keys is missing$/],
    [() => packer.pack(JOINTS, [...clips, undefined]), "TypeError", /^clips\[1\]\.keys is missing$/],
    [() => packer.pack(JOINTS, [...clips, { keys: 7 }]), "TypeError", /^clips\[1\]\.keys is no array$/],
    [() => packer.pack(JOINTS, [{ keys: [] }]), "RangeError", /^clips\[0\]\.keys holds 0 numbers/],
    [() => packer.pack(2, [{ keys: KEYS.subarray(7) }]), "RangeError", /holds 833 numbers, .* of 14, seven a joint/],
    [() => packer.pack(JOINTS, [{ keys: KEYS, rate: 0 }]), "RangeError", /^clips\[0\]\.rate is 0, not a positive/],
    [() => packer.pack(JOINTS, clips, { angle: -1 }), "RangeError", /^angle is -1, not a number from 0 on$/],
    [() => packer.pack(JOINTS, clips, { length: NaN }), "RangeError", /^length is NaN/],
  ])
    fails(call, name, text);
});

test("memory does not grow with what has been packed, and compiled code is taken", async () => {
  const code = await compile(),
    { exports } = await WebAssembly.instantiate(code, {});
  const { constructor: Packer } = packer,
    own = new Packer(exports);
  for (let i = 0; i < 3; i++) own.pack(JOINTS, [{ keys: KEYS }]);
  const before = exports.memory.buffer.byteLength;
  for (let i = 0; i < 300; i++) own.pack(JOINTS, [{ keys: KEYS }]);
  for (let i = 0; i < 300; i++) fails(() => own.pack(JOINTS, changed(3, 2)), "PackError", /length 2/);
  assert.equal(exports.memory.buffer.byteLength, before);
  const other = await loadPacker({ wasm: code });
  assert.deepEqual(other.pack(JOINTS, [{ keys: KEYS }]), own.pack(JOINTS, [{ keys: KEYS }]));
});
