// Files that people drop. A reader throws with the place that is wrong, before anything has changed; what it gives is a
// skeleton with keys [frame][joint][x y z w tx ty tz], and a mesh if the file has one.

const unit = ([x, y, z, w]) => { const n = Math.hypot(x, y, z, w); return [x / n, y / n, z / n, w / n]; };
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

const ARRAYS = { 5120: Int8Array, 5121: Uint8Array, 5122: Int16Array, 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array }, WIDTHS = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 };

export function glb(buffer) {
  const data = new DataView(buffer), fail = (place, what) => { throw new Error(`${place}: ${what}`); };
  if (buffer.byteLength < 20 || data.getUint32(0, true) !== 0x46546c67) fail("byte 0", "this is no .glb");
  if (data.getUint32(4, true) !== 2) fail("byte 4", "this is no glTF 2");
  let json, binary;
  for (let at = 12; at + 8 <= buffer.byteLength;) {
    const length = data.getUint32(at, true), type = data.getUint32(at + 4, true);
    if (at + 8 + length > buffer.byteLength) fail(`byte ${at}`, "a chunk ends beyond the file");
    if (type === 0x4e4f534a) try { json = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, at + 8, length))); } catch (error) { fail(`byte ${at + 8}`, error.message); }
    if (type === 0x004e4942) binary = new Uint8Array(buffer, at + 8, length);
    at += 8 + length;
  }
  if (!json) fail("byte 12", "there is no JSON chunk");
  const read = (index, place) => {
    const of = json.accessors?.[index] ?? fail(place, `there is no accessor ${index}`), view = json.bufferViews?.[of.bufferView] ?? fail(`accessor ${index}`, "there is no such bufferView");
    const Type = ARRAYS[of.componentType] ?? fail(`accessor ${index}`, "unknown component type"), width = WIDTHS[of.type] ?? fail(`accessor ${index}`, "unknown type");
    const size = Type.BYTES_PER_ELEMENT, stride = view.byteStride ?? width * size, start = (view.byteOffset ?? 0) + (of.byteOffset ?? 0);
    if (of.sparse || !binary || start + stride * (of.count - 1) + width * size > binary.byteLength) fail(`accessor ${index}`, "its numbers lie beyond the file");
    const out = new Float64Array(width * of.count), from = new DataView(binary.buffer, binary.byteOffset), get = `get${Type.name.slice(0, -5)}`, most = of.normalized ? 2 ** (8 * size - (Type.name[0] === "U" ? 0 : 1)) - 1 : 1;
    for (let i = 0; i < of.count; i++) for (let k = 0; k < width; k++) out[width * i + k] = from[get](start + stride * i + k * size, true) / most;
    return out;
  };
  const skin = json.skins?.[0] ?? fail("skins", "there is none: nothing here follows joints"), nodes = json.nodes, up = new Map();
  nodes.forEach((node, i) => { for (const child of node.children ?? []) up.set(child, i); });
  // Joints and all above them, parents first.
  const order = [], visit = (i, depth = 0) => { if (depth > nodes.length) fail(`node ${i}`, "is its own ancestor"); if (order.includes(i)) return; if (up.has(i)) visit(up.get(i), depth + 1); order.push(i); };
  for (const joint of skin.joints) { if (!nodes[joint]) fail("skin 0", `there is no node ${joint}`); visit(joint); }
  for (const i of order) {
    const { scale, matrix, name } = nodes[i];
    if (matrix || (scale ?? []).some((s) => Math.abs(s - 1) > 1e-3)) fail(`node ${i}${name ? ` (${name})` : ""}`, "scales or is a matrix: only rigid joints play here");
  }
  // What is in the file and not played is said.
  const left = new Set(), tracks = new Map(), animation = json.animations?.[0];
  if (json.animations?.length > 1) left.add(`${json.animations.length - 1} more animations`);
  if (json.skins.length > 1) left.add(`${json.skins.length - 1} more skins`);
  let end = 0;
  animation?.channels.forEach(({ target, sampler }, c) => {
    if (target.path === "weights") left.add("morph targets");
    else if (target.path === "scale" && order.includes(target.node)) left.add("scale");
    else if (target.node !== undefined && !order.includes(target.node)) left.add("what moves no joint");
    if (!order.includes(target.node) || !["rotation", "translation"].includes(target.path)) return;
    const { input, output, interpolation = "LINEAR" } = animation.samplers[sampler], times = read(input, `channel ${c}`), cubic = interpolation === "CUBICSPLINE";
    end = Math.max(end, times.at(-1));
    tracks.set(`${target.node} ${target.path}`, { times, values: read(output, `channel ${c}`), step: interpolation === "STEP", cubic });
  });
  const RATE = 30, frames = Math.max(2, Math.ceil(end * RATE) + 1), keys = new Float32Array(7 * order.length * frames);
  const sample = (node, path, width, rest, time) => {
    const track = tracks.get(`${node} ${path}`);
    if (!track) return rest;
    const { times, values, step, cubic } = track, after = times.findIndex((t) => t > time), i = after < 0 ? times.length - 1 : Math.max(0, after - 1), j = Math.min(i + 1, times.length - 1);
    // Of a cubic spline each key is a tangent in, the value, and a tangent out, for a second.
    const of = (k, part = 1) => Array.from(cubic ? values.subarray(width * (3 * k + part), width * (3 * k + part + 1)) : values.subarray(width * k, width * (k + 1)));
    const a = of(i), b = of(j), span = times[j] - times[i], s = step || i === j ? 0 : Math.max(0, (time - times[i]) / span);
    if (cubic) {
      const out = of(i, 2), into = of(j, 0), s2 = s * s, s3 = s2 * s;
      return a.map((x, k) => (2 * s3 - 3 * s2 + 1) * x + (s3 - 2 * s2 + s) * span * out[k] + (3 * s2 - 2 * s3) * b[k] + (s3 - s2) * span * into[k]);
    }
    const sign = width === 4 && a.reduce((sum, x, k) => sum + x * b[k], 0) < 0 ? -1 : 1;
    return a.map((x, k) => (1 - s) * x + sign * s * b[k]);
  };
  for (let f = 0; f < frames; f++) order.forEach((node, j) => {
    const { rotation = [0, 0, 0, 1], translation = [0, 0, 0] } = nodes[node];
    keys.set([...unit(sample(node, "rotation", 4, rotation, f / RATE)), ...sample(node, "translation", 3, translation, f / RATE)], 7 * (f * order.length + j));
  });
  const made = { parents: order.map((node) => order.indexOf(up.get(node) ?? -1)), keys, seconds: 1 / RATE };
  const node = nodes.find((node) => node.skin === 0 && node.mesh !== undefined), skinned = json.meshes?.[node?.mesh]?.primitives.filter(({ attributes }) => attributes.JOINTS_0 !== undefined) ?? [], [part] = skinned;
  if (skinned.length > 1) left.add(`${skinned.length - 1} more parts of the mesh`);
  if (part?.attributes.JOINTS_1 !== undefined) left.add("all but four joints of a vertex");
  if (part?.targets) left.add("morph targets");
  if (part) {
    const { POSITION, JOINTS_0, WEIGHTS_0 } = part.attributes, rest = Float32Array.from(read(POSITION, "POSITION")), weights = Float32Array.from(read(WEIGHTS_0, "WEIGHTS_0"));
    const joints = Array.from(read(JOINTS_0, "JOINTS_0"), (joint) => order.indexOf(skin.joints[joint])), binds = Array.from({ length: 16 * skin.joints.length }, (_, i) => (i % 5 === 0 ? 1 : 0));
    const inverse = skin.inverseBindMatrices === undefined ? binds.map((x, i) => (i % 16 % 5 === 0 ? 1 : 0)) : read(skin.inverseBindMatrices, "inverseBindMatrices");
    const poses = new Float32Array(7 * order.length).map((_, i) => (i % 7 === 3 ? 1 : 0));
    skin.joints.forEach((joint, k) => poses.set([...rotation(inverse.slice(16 * k, 16 * k + 16), k, fail), ...inverse.slice(16 * k + 12, 16 * k + 15)], 7 * order.indexOf(joint)));
    made.mesh = { rest, joints, weights, inverseBinds: poses, indices: part.indices === undefined ? Uint32Array.from({ length: rest.length / 3 }, (_, i) => i) : Uint32Array.from(read(part.indices, "indices")) };
  }
  made.what = `${order.length} joints, ${frames} frames at ${RATE} a second${part ? `, ${made.mesh.rest.length / 3} vertices` : ""}${left.size ? `; not played: ${[...left].join(", ")}` : ""}`;
  return made;
}

/** The quaternion of a 4×4 matrix by columns. */
function rotation(m, k, fail) {
  for (let c = 0; c < 12; c += 4) if (Math.abs(Math.hypot(m[c], m[c + 1], m[c + 2]) - 1) > 1e-2) fail(`inverse bind matrix ${k}`, "scales");
  const w = 1 + m[0] + m[5] + m[10], x = 1 + m[0] - m[5] - m[10], y = 1 - m[0] + m[5] - m[10], z = 1 - m[0] - m[5] + m[10], most = Math.max(w, x, y, z);
  if (most === w) return unit([m[6] - m[9], m[8] - m[2], m[1] - m[4], w]);
  if (most === x) return unit([x, m[1] + m[4], m[8] + m[2], m[6] - m[9]]);
  if (most === y) return unit([m[1] + m[4], y, m[6] + m[9], m[8] - m[2]]);
  return unit([m[8] + m[2], m[6] + m[9], z, m[1] - m[4]]);
}
