// The readers of the page: what files hold is played, or the page says what is not.
import assert from "node:assert/strict";
import { test } from "node:test";
import { bvh, glb } from "../page/files.js";
import { File } from "./glb.mjs";

const frame = ({ keys, parents }, f, joint) => {
  const at = 7 * (f * parents.length + joint);
  return Array.from(keys.subarray(at, at + 7));
};
/** A chain of joints, each with one channel, and its frames. */
const chain = (joints, channel, rows, frames = rows.length) => `HIERARCHY
ROOT j
{
OFFSET 0 0 0
CHANNELS 1 ${channel}
${`JOINT j
{
OFFSET 0 1 0
CHANNELS 1 ${channel}
`.repeat(joints - 1)}${"}\n".repeat(joints)}MOTION
Frames: ${frames}
Frame Time: 0.1
${rows.join("\n")}
`;

test("what a file holds and the page does not play is said", () => {
  const file = new File(),
    input = file.accessor("SCALAR", [0, 1]),
    skeleton = { nodes: [{ children: [1] }, {}], skins: [{ joints: [0, 1] }] };
  const channels = [{ target: { node: 1, path: "weights" }, sampler: 0 }],
    moved = { channels, samplers: [{ input, output: input }] };
  const { what } = glb(file.bytes({ ...skeleton, animations: [moved, { channels: [], samplers: [] }] }));
  assert.match(what, /^2 joints, 2 frames at 30 a second; not played: 1 more animations, morph targets$/);
  assert.doesNotMatch(glb(file.bytes(skeleton)).what, /not played/);
});

test("parts of a mesh with four and with eight joints for a vertex are one mesh", () => {
  const file = new File();
  const part = (x, sets) => {
    const attributes = { POSITION: file.accessor("VEC3", [x, 0, 0, 0, x, 0, 0, 0, x]) };
    for (let k = 0; k < sets; k++) {
      const weights = [1, 0, 0, 0, 1, 0, 0, 0, 0.5, 0, 0, 0.5].map((w) => w / sets);
      attributes[`JOINTS_${k}`] = file.accessor("VEC4", Uint8Array.of(0, 1, 1, 0, 1, 0, 0, 1, 0, 0, 0, 0));
      attributes[`WEIGHTS_${k}`] = file.accessor("VEC4", weights);
    }
    return { attributes };
  };
  const meshes = [{ primitives: [part(1, 1), part(2, 2)] }],
    nodes = [{ children: [1] }, {}, { mesh: 0, skin: 0 }];
  const { mesh, keys, what } = glb(file.bytes({ nodes, meshes, skins: [{ joints: [0, 1] }] }));
  assert.match(what, /^2 joints, 2 frames at 30 a second, 6 vertices$/);
  assert.deepEqual([...mesh.rest].filter((x) => x), [1, 1, 1, 2, 2, 2]);
  assert.deepEqual([...mesh.indices], [0, 1, 2, 3, 4, 5]);
  assert.deepEqual([...mesh.weights.subarray(16, 24)], [0.5, 0, 0, 0.5, 0, 0, 0, 0]);
  assert.deepEqual([...mesh.weights.subarray(40)], [0.25, 0, 0, 0.25, 0.25, 0, 0, 0.25]);
  assert.deepEqual([...mesh.joints.subarray(32, 40)], [1, 0, 0, 0, 1, 0, 0, 0], "joints without weight are the first");
  assert.deepEqual(keys.length, 2 * 2 * 7);
});

test("names with spaces, a frame too many, a byte 0x1A and no space behind a colon are read", () => {
  const text = ["HIERARCHY", "ROOT the hips", "{", "OFFSET 0 0 0", "CHANNELS 3 Xposition Yposition Zposition",
    "JOINT left leg", "{", "OFFSET 0 1 0", "CHANNELS 1 Zrotation", "}", "}", "MOTION", "Frames:2", "Frame Time:0.1",
    "1 2 3 0", "4 5 6 90", ""].join("\n");
  const plain = bvh(text);
  assert.deepEqual(plain.parents, [-1, 0]);
  assert.deepEqual(frame(plain, 1, 0).slice(4), [4, 5, 6]);
  assert.deepEqual(bvh(`${text}\x1a`).keys, plain.keys);
  const more = bvh(`${text}7 8 9 0\n`);
  assert.deepEqual(more.keys, plain.keys);
  assert.match(more.what, /a frame more than it says is left out/);
  assert.throws(() => bvh(`${text}7 8\n`), /line 17: the end is expected, not 7/);
});

test("numbers are those of JavaScript, however they are written", () => {
  const given = ["0.1", "-0", "+5", "1e-3", "-2.5E2", ".5", "5.", "123456789012345", "0.30000000000000004", "-.125",
    "1234567.8901234", "00012.50", "1e22", "9007199254740993", "0.000000000000001"];
  const { keys } = bvh(chain(1, "Xposition", given));
  given.forEach((text, f) => {
    const x = keys[7 * f + 4];
    assert.ok(Object.is(x, Math.fround(Number(text))), `${text}: ${x}`);
  });
  for (const word of [".", "-", "1.2.3", "1-2", "--1", "12a", "Infinity"]) {
    const bad = new RegExp(`^Error: line 11: a number is expected, not ${word.replaceAll(".", "\\.")}$`);
    assert.throws(() => bvh(chain(1, "Xposition", ["1", word])), bad);
  }
});

test("more frames than a file or memory holds are told by their line, before memory is taken", () => {
  const { Float32Array } = globalThis;
  globalThis.Float32Array = function () {
    throw new Error("memory is taken");
  };
  try {
    assert.throws(() => bvh(chain(1, "Xposition", ["1"], 2)), /^Error: line 10: the file ends too early$/);
    assert.throws(() => bvh(chain(1, "Xposition", ["1"], 3e7)), /^Error: line 10: the file ends too early$/);
    assert.throws(() => bvh(chain(1, "Xposition", ["1"], 1e8)), /^Error: line 8: .*memory holds.*, not 100000000$/);
  } finally {
    Object.assign(globalThis, { Float32Array });
  }
});

test("ten minutes of sixty joints are read in less than a second, and how far a reader is is told", (t) => {
  const [joints, frames] = [60, 18000],
    file = new File(),
    input = file.accessor("SCALAR", Float32Array.from({ length: frames }, (_, f) => f / 30));
  const outputs = Array.from({ length: joints }, (_, j) => {
    const turns = new Float32Array(4 * frames);
    for (let f = 0; f < frames; f++) {
      const half = 0.4 * Math.sin(0.05 * f + j);
      turns.set([Math.sin(half), 0, 0, Math.cos(half)], 4 * f);
    }
    return file.accessor("VEC4", turns);
  });
  const bytes = file.bytes({
    nodes: outputs.map((_, j) => ({ children: j + 1 < joints ? [j + 1] : [] })),
    skins: [{ joints: outputs.map((_, j) => j) }],
    animations: [{
      channels: outputs.map((_, j) => ({ target: { node: j, path: "rotation" }, sampler: j })),
      samplers: outputs.map((output) => ({ input, output })),
    }],
  });
  const rows = Array.from({ length: frames }, (_, f) => {
    return Array.from({ length: joints }, (_, j) => (45 * Math.sin(0.05 * f + j)).toFixed(5)).join(" ");
  });
  const text = chain(joints, "Xrotation", rows),
    parts = [];
  for (const [name, read] of [["glTF", () => glb(bytes)], ["BVH", () => bvh(text, (part) => parts.push(part))]]) {
    // The time of this process alone: others share the machine.
    const before = process.cpuUsage(),
      made = read(),
      { user, system } = process.cpuUsage(before);
    t.diagnostic(`${name}: ${Math.round((user + system) / 1000)} ms`);
    assert.equal(made.keys.length, 7 * joints * frames);
    assert.ok(user + system < 1e6, `${name}: ${user + system} µs`);
  }
  assert.equal(parts.length, 100);
  assert.ok(parts.every((part, i) => Math.abs(part - i / 100) < 1e-12));
});
