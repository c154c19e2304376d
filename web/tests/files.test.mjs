// The readers of the page: what files hold is played, or the page says what is not.
import assert from "node:assert/strict";
import { test } from "node:test";
import { bvh, glb } from "../page/files.js";

/** A binary glTF of this JSON, whose accessors are these arrays of floats, by type. */
function file(json, arrays) {
  const floats = arrays.flatMap(([, numbers]) => numbers);
  let start = 0;
  json.bufferViews = []; json.accessors = [];
  for (const [type, numbers] of arrays) {
    const width = { SCALAR: 1, VEC3: 3, VEC4: 4 }[type];
    json.bufferViews.push({ buffer: 0, byteOffset: 4 * start, byteLength: 4 * numbers.length });
    json.accessors.push({ bufferView: json.bufferViews.length - 1, componentType: 5126, type, count: numbers.length / width });
    start += numbers.length;
  }
  json.buffers = [{ byteLength: 4 * start }];
  let text = JSON.stringify({ asset: { version: "2.0" }, ...json });
  text += " ".repeat(-text.length & 3);
  const bytes = new ArrayBuffer(12 + 8 + text.length + 8 + 4 * start), data = new DataView(bytes);
  [0x46546c67, 2, bytes.byteLength, text.length, 0x4e4f534a].forEach((word, i) => data.setUint32(4 * i, word, true));
  new Uint8Array(bytes, 20, text.length).set(new TextEncoder().encode(text));
  data.setUint32(20 + text.length, 4 * start, true);
  data.setUint32(24 + text.length, 0x004e4942, true);
  floats.forEach((x, i) => data.setFloat32(28 + text.length + 4 * i, x, true));
  return bytes;
}

const skeleton = { nodes: [{ children: [1] }, {}], skins: [{ joints: [0, 1] }] };
const frame = ({ keys, parents }, f, joint) => Array.from(keys.subarray(7 * (f * parents.length + joint), 7 * (f * parents.length + joint) + 7));
const near = (found, wanted) => found.forEach((x, i) => assert.ok(Math.abs(x - wanted[i]) < 1e-6, `${found} for ${wanted}`));

test("cubic splines are Hermite's, of quaternions normalized", () => {
  // From (0, 1, 0) with the tangent (3, 0, 0) to (0, 2, 0) with (0, 3, 0), over one second; rotations over two.
  const animations = [{
    channels: [{ target: { node: 1, path: "translation" }, sampler: 0 }, { target: { node: 0, path: "rotation" }, sampler: 1 }],
    samplers: [{ input: 0, output: 1, interpolation: "CUBICSPLINE" }, { input: 2, output: 3, interpolation: "CUBICSPLINE" }],
  }];
  const h = Math.SQRT1_2, made = glb(file({ ...skeleton, animations }, [
    ["SCALAR", [0, 1]],
    ["VEC3", [9, 9, 9, 0, 1, 0, 3, 0, 0, 0, 3, 0, 0, 2, 0, 9, 9, 9]],
    ["SCALAR", [0, 2]],
    ["VEC4", [0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, h, h, 0, 0, 0, 0]],
  ]));
  const hermite = (s) => {
    const out = s * (1 - s) ** 2, into = s * s * (s - 1), last = s * s * (3 - 2 * s);
    return [3 * out, 1 - last + 2 * last + 3 * into, 0];
  };
  near(hermite(0.25), [0.421875, 1.015625, 0]);
  near(hermite(0.5), [0.375, 1.125, 0]);
  for (const f of [0, 3, 15, 21, 30]) near(frame(made, f, 1).slice(4), hermite(f / 30));
  // Half way: (0, 0, 1, 0) · 2 s · ⅛, and the mean of the ends.
  const z = 0.25 + h / 2, w = (1 + h) / 2, n = Math.hypot(z, w);
  near(frame(made, 30, 0).slice(0, 4), [0, 0, z / n, w / n]);
});

test("what a file holds and the page does not play is said", () => {
  const animations = [{
    channels: [{ target: { node: 1, path: "scale" }, sampler: 0 }, { target: { node: 1, path: "weights" }, sampler: 0 }],
    samplers: [{ input: 0, output: 0 }],
  }, { channels: [], samplers: [] }];
  const { what } = glb(file({ ...skeleton, animations }, [["SCALAR", [0, 1]]]));
  assert.match(what, /not played: 1 more animations, scale, morph targets/);
  assert.doesNotMatch(glb(file({ ...skeleton }, [["SCALAR", [0]]])).what, /not played/);
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
