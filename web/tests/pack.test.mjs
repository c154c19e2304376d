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
/**
 * The bound of a rotation, in radians. Of the sixteen lengths of a key, 32767 to 32764.19, one brings the largest
 * number within 3/32 of an integer, and the other three are off by 1/2 at most: 2 √(3/4 + 9/1024) / 32764.19 is
 * 5.318e-5. The rest of the bound is for the rounding of 32-bit numbers.
 */
const ANGLE = 5.4e-5;
/** The bound of a coordinate along a side of four units. */
const LENGTH = 4 / 131068 + 1e-7;

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
/** The angle between two rotations at a place of two arrays of keys, in radians. */
const angle = (a, b, at) => {
  const quaternions = [a, b].map((keys) => Array.from(keys.slice(at, at + 4)).map(Number)),
    [one, two] = quaternions.map((q) => q.map((x) => x / Math.hypot(...q))),
    side = Math.sign(one.reduce((sum, x, c) => sum + x * two[c], 0));
  return 4 * Math.asin(Math.hypot(...one.map((x, c) => x - side * two[c])) / 2);
};
/** The keys that a clip of packed bytes plays at its frames. */
const played = (bytes, parents, frames, clip = 0) => {
  const at = dq8.floats(Array.from({ length: frames }, (_, frame) => frame)),
    motions = dq8.motions(parents.length * frames),
    keys = dq8.floats(7 * parents.length * frames);
  dq8.skeleton(parents).locals(dq8.packedClip(bytes).sample(at, clip), motions);
  dq8.toRotationsTranslations(motions, keys);
  return keys.view.slice();
};
/** Numbers from 0 to 1, the same in each run. */
let state = 1;
const random = () => (state = (state * 48271) % 2147483647) / 2147483647;
/** A direction of so many numbers, by refusing what lies outside of the ball. */
const direction = (n) => {
  for (;;) {
    const x = Array.from({ length: n }, () => 2 * random() - 1),
      size = Math.hypot(...x);
    if (size > 0.1 && size < 1) return x.map((c) => c / size);
  }
};
/** The rotation about an axis, times a rotation. */
const turned = (axis, size, [x, y, z, w]) => {
  const [a, b, c] = axis.map((i) => i * Math.sin(size / 2)),
    d = Math.cos(size / 2);
  return [d * x + a * w + b * z - c * y, d * y - a * z + b * w + c * x, d * z + a * y - b * x + c * w,
    d * w - a * x - b * y - c * z];
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
    const turn = angle(wanted, got, i);
    assert.ok(turn <= ANGLE, `${turn} radians at ${i}`);
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

test("rotations about all axes are within the bound, which the worst of them nearly reach", () => {
  const frames = 2000,
    still = [0, 0, 0];
  const anywhere = () => Float32Array.from(Array.from({ length: frames }, () => [...direction(4), ...still]).flat());
  // Three numbers that all lengths of a key leave half way between two integers.
  const between = Float32Array.from(Array.from({ length: 27 }, (_, i) => {
    const small = [i % 3, Math.floor(i / 3) % 3, Math.floor(i / 9)].map((n) => (n + 0.5) / 32765.6);
    return [...small, Math.sqrt(1 - Math.hypot(...small) ** 2), ...still];
  }).flat());
  const clips = [anywhere(), between, anywhere()],
    bytes = packer.pack(1, clips.map((keys) => ({ keys })), { angle: 0 });
  const worst = clips.map((keys, clip) => {
    const got = played(bytes, [-1], keys.length / 7, clip);
    return Math.max(...Array.from({ length: keys.length / 7 }, (_, frame) => angle(keys, got, 7 * frame)));
  });
  assert.ok(Math.max(...worst) <= ANGLE, `${worst} radians`);
  assert.ok(worst[1] > 5.2e-5 && worst[0] > 4e-5, `${worst} radians`);
});

test("tracks within limits are one key, and off by no more than limit and bound", () => {
  const frames = 50,
    limits = { angle: 0.01, length: 0.02 };
  // In both clips the first joint turns and moves about a place of its own, within limits of the first frame. The
  // clips are far apart for it. The second joint moves along no axis by more than the limit.
  const clip = (far) => {
    const start = direction(4);
    return Array.from({ length: frames }, (_, frame) => {
      const turn = turned(direction(3), frame ? 0.999 * limits.angle * Math.sqrt(random()) : 0, start),
        shift = () => far + (frame ? 0.999 * limits.length * (2 * random() - 1) : 0);
      return [...turn, shift(), shift(), shift(), 0, 0, 0, 1, ...[0, 0, 0].map(() => 0.999 * limits.length * random())];
    }).flat();
  };
  const clips = [clip(0), clip(1), clip(3)].map((keys) => Float32Array.from(keys)),
    bytes = packer.pack(2, clips.map((keys) => ({ keys })), limits),
    worst = [0, 0, 0];
  // Rotations of two joints and a translation of one, in each of three clips.
  const one = packer.pack(2, [{ keys: clips[0] }], limits);
  assert.equal(bytes.length - one.length, 2 * (3 * 8 + 16 + 12));
  clips.forEach((keys, number) => {
    const got = played(bytes, [-1, -1], frames, number);
    for (let at = 0; at < keys.length; at += 14) {
      worst[0] = Math.max(worst[0], angle(keys, got, at));
      for (let c = 4; c < 7; c++) {
        worst[1] = Math.max(worst[1], Math.abs(keys[at + c] - got[at + c]));
        worst[2] = Math.max(worst[2], Math.abs(keys[at + 7 + c] - got[at + 7 + c]));
      }
    }
  });
  const bounds = [limits.angle + ANGLE, limits.length + 3.04 / 131068 + 1e-6, limits.length / 2 + 1e-6];
  worst.forEach((off, i) => assert.ok(off <= bounds[i] && off > 0.9 * bounds[i], `${off} of ${bounds[i]} for ${i}`));
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
  const large = fails(() => packer.pack(32769, [{ keys: wide }]), "PackError", /more tracks than 15 bits count$/);
  assert.deepEqual([large.clip, large.value], [undefined, undefined]);
  // After errors as before.
  assert.equal(dq8.packedClip(packer.pack(JOINTS, [{ keys: KEYS }])).clips, 1);
});

test("wrong arguments are named", () => {
  const clips = [{ keys: KEYS }],
    stale = dq8.floats(21).view,
    EMPTY = /^clips\[1\]\.keys is empty, or a view from before memory has grown$/;
  dq8.floats(1 << 22).free();
  assert.equal(stale.length, 0);
  for (const [call, name, text] of [
    [() => packer.pack(), "TypeError", /^joints is missing$/],
    [() => packer.pack(0, clips), "RangeError", /^joints is 0/],
    [() => packer.pack(1.5, clips), "RangeError", /^joints is 1.5, not a whole number$/],
    [() => packer.pack(JOINTS), "TypeError", /^clips is missing$/],
    [() => packer.pack(JOINTS, KEYS), "TypeError", /^clips is no array$/],
    [() => packer.pack(JOINTS, []), "RangeError", /^clips is empty$/],
    [() => packer.pack(JOINTS, [{}]), "TypeError", /^clips\[0\]\.keys is missing$/],
    [() => packer.pack(JOINTS, [...clips, undefined]), "TypeError", /^clips\[1\] is missing$/],
    [() => packer.pack(JOINTS, [...clips, , ...clips]), "TypeError", /^clips\[1\] is missing$/],
    [() => packer.pack(JOINTS, [...clips, null]), "TypeError", /^clips\[1\] is no object$/],
    [() => packer.pack(JOINTS, [...clips, "ab"]), "TypeError", /^clips\[1\] is no object$/],
    [() => packer.pack(JOINTS, [...clips, { keys: 7 }]), "TypeError", /^clips\[1\]\.keys is no array of numbers$/],
    [() => packer.pack(JOINTS, [{ keys: null }]), "TypeError", /^clips\[0\]\.keys is no array of numbers$/],
    [() => packer.pack(JOINTS, [{ keys: "x".repeat(21) }]), "TypeError", /^clips\[0\]\.keys is no array of numbers$/],
    [() => packer.pack(JOINTS, [{ keys: { length: -21 } }]), "TypeError", /^clips\[0\]\.keys is no array of/],
    [() => packer.pack(JOINTS, [{ keys: dq8.floats(21) }]), "TypeError", /^clips\[0\]\.keys is no array of numbers$/],
    [() => packer.pack(JOINTS, [{ keys: new BigInt64Array(21) }]), "TypeError", /^clips\[0\]\.keys is no array of/],
    [() => packer.pack(JOINTS, [...clips, { keys: [] }]), "RangeError", EMPTY],
    [() => packer.pack(JOINTS, [...clips, { keys: stale }]), "RangeError", EMPTY],
    [() => packer.pack(2, [{ keys: KEYS.subarray(7) }]), "RangeError", /holds 833 numbers, .* of 14, seven a joint/],
    [() => packer.pack(JOINTS, [{ keys: KEYS, rate: 0 }]), "RangeError", /^clips\[0\]\.rate is 0, not a positive/],
    [() => packer.pack(JOINTS, [{ keys: KEYS, rate: "30" }]), "TypeError", /^clips\[0\]\.rate is 30, not a positive/],
    [() => packer.pack(JOINTS, [{ keys: KEYS, rate: null }]), "TypeError", /^clips\[0\]\.rate is null, not a positive/],
    [() => packer.pack(JOINTS, clips, null), "TypeError", /^limits is no object$/],
    [() => packer.pack(JOINTS, clips, 1e-3), "TypeError", /^limits is no object$/],
    [() => packer.pack(JOINTS, clips, { angle: -1 }), "RangeError", /^limits\.angle is -1, not a number from 0 on$/],
    [() => packer.pack(JOINTS, clips, { angle: null }), "TypeError", /^limits\.angle is null, not a number/],
    [() => packer.pack(JOINTS, clips, { length: NaN }), "RangeError", /^limits\.length is NaN, not a number/],
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

test("the module exports the functions that the packer calls, and no others", async () => {
  const exported = WebAssembly.Module.exports(await compile()).map(({ name }) => name);
  assert.deepEqual(exported.filter((name) => name.startsWith("dq8_")).sort(), [
    "dq8_allocate", "dq8_free", "dq8_pack", "dq8_packed_bytes", "dq8_packed_free", "dq8_packed_length",
  ]);
});
