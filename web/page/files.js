// Files that people drop. A reader throws with the place that is wrong, before anything has changed; what it gives is a
// skeleton with keys [frame][joint][x y z w tx ty tz], and a mesh if the file has one.
import { readGltf } from "../package/gltf.js";

const multiply = ([a, b, c, d], [x, y, z, w]) => [d * x + a * w + b * z - c * y, d * y + b * w + c * x - a * z, d * z + c * w + a * y - b * x, d * w - a * x - b * y - c * z];

export function bvh(text) {
  const words = [];
  // A byte 0x1A at the end, and no space behind a colon, are in files of well-known programs.
  text.replace(/[\x1a\0\s]+$/, "").split(/\r?\n/).forEach((line, i) => { line = line.replace(/^(\s*(?:frames|frame time):)/i, "$1 "); for (const word of line.trim().split(/\s+/)) if (word) words.push([word, i + 1]); });
  let next = 0;
  const wrong = (what) => { const [word, line] = words[Math.min(next, words.length) - 1] ?? ["nothing", 1]; throw new Error(`line ${line}: ${what}, not ${word.slice(0, 40)}`); };
  const take = () => { if (next >= words.length) throw new Error(`line ${words.at(-1)?.[1] ?? 1}: the file ends too early`); return words[next++][0]; };
  const expect = (word) => { if (take().toUpperCase() !== word) wrong(`${word} is expected`); };
  const number = () => { const x = Number(take()); if (!Number.isFinite(x)) wrong("a number is expected"); return x; };
  const joints = [], CHANNEL = /^([XYZ])(position|rotation)$/i;
  function joint(parent) {
    // A name may have spaces, up to the end of its line.
    const parts = [take()], line = words[next - 1][1];
    while (words[next]?.[1] === line && words[next][0] !== "{") parts.push(take());
    const name = parts.join(" "), own = { name, parent, offset: [0, 0, 0], channels: [] }, index = joints.push(own) - 1;
    expect("{");
    for (;;) {
      const word = take().toUpperCase();
      if (word === "OFFSET") own.offset = [number(), number(), number()];
      else if (word === "CHANNELS") for (let n = number(); n > 0; n--) { const found = CHANNEL.exec(take()); if (!found) wrong("a channel is expected"); own.channels.push(found[1].toUpperCase() + found[2][0].toLowerCase()); }
      else if (word === "JOINT") joint(index);
      else if (word === "END") { take(); expect("{"); expect("OFFSET"); const offset = [number(), number(), number()]; expect("}"); joints.push({ name: `${name} end`, parent: index, offset, channels: [] }); }
      else if (word === "}") return;
      else wrong("OFFSET, CHANNELS, JOINT, End Site or } is expected");
    }
  }
  expect("HIERARCHY"); expect("ROOT"); joint(-1); expect("MOTION"); expect("FRAMES:");
  const frames = number();
  if (!(frames >= 1 && frames === Math.floor(frames))) wrong("a number of frames is expected");
  expect("FRAME"); expect("TIME:");
  const seconds = number();
  if (!(seconds > 0)) wrong("a time of more than 0 is expected");
  const keys = new Float32Array(7 * joints.length * frames);
  for (let f = 0, to = 0; f < frames; f++) for (const { offset, channels } of joints) {
    let q = [0, 0, 0, 1];
    const t = offset.slice();
    for (const [axis, kind] of channels) {
      const k = "XYZ".indexOf(axis), value = number();
      if (kind === "p") { t[k] = value; continue; }
      const turn = [0, 0, 0, Math.cos(value * Math.PI / 360)];
      turn[k] = Math.sin(value * Math.PI / 360);
      q = multiply(q, turn);
    }
    keys.set([...q, ...t], to);
    to += 7;
  }
  const more = words.length - next, one = joints.reduce((sum, { channels }) => sum + channels.length, 0);
  if (more > 0 && more !== one) { next++; wrong("the end is expected"); }
  const left = more > 0 ? "; a frame more than it says is left out" : "";
  return { parents: joints.map(({ parent }) => parent), keys: frames > 1 ? keys : Float32Array.of(...keys, ...keys), seconds, what: `${joints.length} joints, ${frames} frames${left}` };
}

/** The first clip and the first skin of a binary glTF. */
export function glb(buffer) {
  const { parents, rest, clips: [clip, ...clips], skins: [skin, ...skins], left } = readGltf(buffer), joints = parents.length;
  // What is in the file and not played is said.
  const more = [[clips, "animations"], [skins, "skins"]].flatMap(([all, what]) => (all.length ? [`${all.length} more ${what}`] : []));
  const { primitives } = skin, made = { parents, keys: clip?.keys ?? Float32Array.of(...rest, ...rest), seconds: 1 / (clip?.rate ?? 30) };
  if (primitives.length) {
    const influences = Math.max(...primitives.map((part) => part.influences)), vertices = primitives.reduce((sum, { positions }) => sum + positions.length / 3, 0);
    const mesh = { influences, rest: new Float32Array(3 * vertices), joints: new Uint16Array(influences * vertices), weights: new Float32Array(influences * vertices), indices: [], inverseBinds: skin.inverseBinds };
    let first = 0;
    for (const { influences: own, positions, joints: which, weights, indices } of primitives) {
      mesh.rest.set(positions, 3 * first);
      for (const index of indices) mesh.indices.push(first + index);
      for (let v = 0; v < positions.length / 3; v++, first++) {
        mesh.joints.set(which.subarray(own * v, own * (v + 1)), influences * first);
        mesh.weights.set(weights.subarray(own * v, own * (v + 1)), influences * first);
      }
    }
    made.mesh = mesh;
  }
  const missing = [...more, ...left], frames = made.keys.length / 7 / joints;
  made.what = `${joints} joints, ${frames} frames at ${Math.round(10 / made.seconds) / 10} a second${made.mesh ? `, ${made.mesh.rest.length / 3} vertices` : ""}${missing.length ? `; not played: ${missing.join(", ")}` : ""}`;
  return made;
}
