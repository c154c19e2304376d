// The readers of the page: what files hold is played, or the page says what is not.
import assert from "node:assert/strict";
import { test } from "node:test";
import { bvh, glb } from "../page/files.js";
import { File } from "./glb.mjs";

const frame = ({ keys, parents }, f, joint) => Array.from(keys.subarray(7 * (f * parents.length + joint), 7 * (f * parents.length + joint) + 7));

test("what a file holds and the page does not play is said", () => {
  const file = new File(), input = file.accessor("SCALAR", [0, 1]), skeleton = { nodes: [{ children: [1] }, {}], skins: [{ joints: [0, 1] }] };
  const moved = { channels: [{ target: { node: 1, path: "weights" }, sampler: 0 }], samplers: [{ input, output: input }] };
  const { what } = glb(file.bytes({ ...skeleton, animations: [moved, { channels: [], samplers: [] }] }));
  assert.match(what, /^2 joints, 2 frames at 30 a second; not played: 1 more animations, morph targets$/);
  assert.doesNotMatch(glb(file.bytes(skeleton)).what, /not played/);
});

test("parts of a mesh with four and with eight joints for a vertex are one mesh", () => {
  const file = new File(), part = (x, sets) => {
    const attributes = { POSITION: file.accessor("VEC3", [x, 0, 0, 0, x, 0, 0, 0, x]) };
    for (let k = 0; k < sets; k++) {
      attributes[`JOINTS_${k}`] = file.accessor("VEC4", Uint8Array.of(0, 1, 1, 0, 1, 0, 0, 1, 0, 0, 0, 0));
      attributes[`WEIGHTS_${k}`] = file.accessor("VEC4", [1, 0, 0, 0, 1, 0, 0, 0, 0.5, 0, 0, 0.5].map((w) => w / sets));
    }
    return { attributes };
  };
  const meshes = [{ primitives: [part(1, 1), part(2, 2)] }], nodes = [{ children: [1] }, {}, { mesh: 0, skin: 0 }];
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
  const text = "HIERARCHY\nROOT the hips\n{\nOFFSET 0 0 0\nCHANNELS 3 Xposition Yposition Zposition\nJOINT left leg\n{\nOFFSET 0 1 0\nCHANNELS 1 Zrotation\n}\n}\nMOTION\nFrames:2\nFrame Time:0.1\n1 2 3 0\n4 5 6 90\n";
  const plain = bvh(text);
  assert.deepEqual(plain.parents, [-1, 0]);
  assert.deepEqual(frame(plain, 1, 0).slice(4), [4, 5, 6]);
  assert.deepEqual(bvh(`${text}\x1a`).keys, plain.keys);
  const more = bvh(`${text}7 8 9 0\n`);
  assert.deepEqual(more.keys, plain.keys);
  assert.match(more.what, /a frame more than it says is left out/);
  assert.throws(() => bvh(`${text}7 8\n`), /line 17: the end is expected, not 7/);
});
