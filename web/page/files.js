// Files that people drop. A reader throws with the place that is wrong; what it gives is a skeleton
// with keys [frame][joint][x y z w tx ty tz], and a mesh if the file has one.
import { readGlb, readGltf } from "../package/gltf.js";

/** How many numbers of keys memory holds. */
const MOST = 2 ** 28;
const TENS = Array.from({ length: 16 }, (_, k) => 10 ** k);

/** The words of a text, with lines for errors alone. */
class Words {
  #text;
  #end;
  #at = 0;
  #start = 0;
  constructor(text) {
    this.#text = text;
    // A byte 0x1A at the end is in files of a well-known program.
    for (this.#end = text.length; this.#end && text.charCodeAt(this.#end - 1) <= 32; this.#end--);
  }
  #skip() {
    while (this.#at < this.#end && this.#text.charCodeAt(this.#at) <= 32) this.#at++;
  }
  #line(at) {
    let line = 1;
    for (let i = this.#text.indexOf("\n"); i >= 0 && i < at; i = this.#text.indexOf("\n", i + 1)) line++;
    return line;
  }
  wrong(what) {
    const word = this.#text.slice(this.#start, Math.min(this.#at, this.#start + 40));
    throw new Error(`line ${this.#line(this.#start)}: ${what}, not ${word || "nothing"}`);
  }
  /** Throws unless so many words are left; a word and the space behind it have two characters. */
  need(words) {
    if (2 * words - 1 > this.#end - this.#at) {
      throw new Error(`line ${this.#line(Math.max(0, this.#end - 1))}: the file ends too early`);
    }
  }
  take() {
    this.#skip();
    this.need(1);
    this.#start = this.#at;
    while (this.#at < this.#end && this.#text.charCodeAt(this.#at) > 32) this.#at++;
    return this.#text.slice(this.#start, this.#at);
  }
  /** Nothing, but for a word that ends with a colon, may follow without a space. */
  expect(word) {
    const got = this.take().toUpperCase();
    if (word.endsWith(":") && got.startsWith(word)) this.#at = this.#start + word.length;
    else if (got !== word) this.wrong(`${word} is expected`);
  }
  number() {
    this.#skip();
    const plain = this.#plain();
    if (plain !== undefined) return plain;
    const x = Number(this.take());
    if (!Number.isFinite(x)) this.wrong("a number is expected");
    return x;
  }
  /**
   * A number of at most 15 digits without an exponent, which is most of a file: quotients of whole
   * numbers and powers of ten that are exact are rounded as `Number` rounds.
   */
  #plain() {
    const text = this.#text,
      minus = text.charCodeAt(this.#at) === 45;
    let at = this.#at + minus,
      whole = 0,
      digits = 0,
      behind = 0;
    for (; at < this.#end; at++) {
      const code = text.charCodeAt(at);
      if (code >= 48 && code <= 57) {
        whole = 10 * whole + code - 48;
        if (++digits > 15) return undefined;
        if (behind) behind++;
      } else if (code === 46 && !behind) behind = 1;
      else if (code <= 32) break;
      else return undefined;
    }
    if (!digits) return undefined;
    [this.#start, this.#at] = [this.#at, at];
    const size = behind ? whole / TENS[behind - 1] : whole;
    return minus ? -size : size;
  }
  /** Passes a name, which may have spaces, up to the end of its line. */
  name() {
    this.take();
    const end = this.#text.indexOf("\n", this.#at),
      brace = this.#text.indexOf("{", this.#at);
    this.#at = Math.min(this.#end, ...[end, brace].filter((i) => i >= 0));
  }
  /** Whether words are left: none, or `some`, which are passed; others are wrong. */
  ends(some) {
    const from = this.#at;
    let count = 0;
    for (this.#skip(); this.#at < this.#end && count <= some; this.#skip(), count++) this.take();
    if (count === 0 || count === some) return count === 0;
    this.#at = from;
    this.take();
    return this.wrong("the end is expected");
  }
}

const CHANNEL = /^([XYZ])(position|rotation)$/i;
/** The channels of a joint: [axis, whether it turns]. */
function channels(words) {
  return Array.from({ length: words.number() }, () => {
    const found = CHANNEL.exec(words.take()) ?? words.wrong("a channel is expected");
    return ["XYZ".indexOf(found[1].toUpperCase()), found[2].toLowerCase() === "rotation"];
  });
}

const vector = (words) => [words.number(), words.number(), words.number()];

function joint(words, joints, parent) {
  const own = { parent, offset: [0, 0, 0], channels: [] },
    index = joints.push(own) - 1;
  words.name();
  words.expect("{");
  for (;;) {
    const word = words.take().toUpperCase();
    if (word === "OFFSET") own.offset = vector(words);
    else if (word === "CHANNELS") own.channels.push(...channels(words));
    else if (word === "JOINT") joint(words, joints, index);
    else if (word === "END") {
      for (const part of ["SITE", "{", "OFFSET"]) words.expect(part);
      joints.push({ parent: index, offset: vector(words), channels: [] });
      words.expect("}");
    } else if (word === "}") return;
    else words.wrong("OFFSET, CHANNELS, JOINT, End Site or } is expected");
  }
}

/** Turns on about an axis, by degrees. */
function spin(q, k, degrees) {
  const s = Math.sin((degrees * Math.PI) / 360),
    c = Math.cos((degrees * Math.PI) / 360),
    [i, j] = [(k + 1) % 3, (k + 2) % 3],
    [a, b, d, w] = [q[k], q[i], q[j], q[3]];
  q[k] = c * a + s * w;
  q[i] = c * b + s * d;
  q[j] = c * d - s * b;
  q[3] = c * w - s * a;
}

/** `progress` is called with the part that has been read. */
export function bvh(text, progress) {
  const words = new Words(text),
    joints = [];
  words.expect("HIERARCHY");
  words.expect("ROOT");
  joint(words, joints, -1);
  words.expect("MOTION");
  words.expect("FRAMES:");
  const frames = words.number(),
    row = joints.reduce((sum, { channels }) => sum + channels.length, 0);
  if (!(frames >= 1 && frames === Math.floor(frames))) words.wrong("a number of frames is expected");
  if (!(7 * joints.length * frames < MOST)) words.wrong("a number of frames that memory holds is expected");
  words.expect("FRAME");
  words.expect("TIME:");
  const seconds = words.number();
  if (!(seconds > 0)) words.wrong("a time of more than 0 is expected");
  words.need(frames * row);
  // A file of one frame stands still for two.
  const keys = new Float32Array(7 * joints.length * Math.max(2, frames)),
    q = [0, 0, 0, 1],
    t = [0, 0, 0];
  for (let f = 0, to = 0; f < frames; f++) {
    if (f % Math.ceil(frames / 100) === 0) progress?.(f / frames);
    for (const { offset, channels } of joints) {
      for (let k = 0; k < 3; k++) [q[k], t[k]] = [0, offset[k]];
      q[3] = 1;
      for (const [axis, turns] of channels) {
        const value = words.number();
        if (turns) spin(q, axis, value);
        else t[axis] = value;
      }
      keys.set(q, to);
      keys.set(t, to + 4);
      to += 7;
    }
  }
  if (frames === 1) keys.copyWithin(keys.length / 2, 0);
  const left = words.ends(row) ? "" : "; a frame more than it says is left out";
  const parents = joints.map(({ parent }) => parent);
  return { parents, keys, seconds, what: `${joints.length} joints, ${frames} frames${left}` };
}

/** The primitives of a skin as one mesh. */
function meshOf({ primitives, inverseBinds }) {
  const influences = Math.max(...primitives.map((part) => part.influences)),
    vertices = primitives.reduce((sum, { positions }) => sum + positions.length / 3, 0),
    rest = new Float32Array(3 * vertices),
    joints = new Uint16Array(influences * vertices),
    weights = new Float32Array(influences * vertices),
    indices = new Uint32Array(primitives.reduce((sum, part) => sum + part.indices.length, 0));
  let first = 0,
    next = 0;
  for (const { influences: own, positions, joints: which, weights: shares, indices: corners } of primitives) {
    rest.set(positions, 3 * first);
    for (const corner of corners) indices[next++] = first + corner;
    for (let v = 0; v < positions.length / 3; v++, first++) {
      joints.set(which.subarray(own * v, own * (v + 1)), influences * first);
      weights.set(shares.subarray(own * v, own * (v + 1)), influences * first);
    }
  }
  return { influences, rest, joints, weights, indices, inverseBinds };
}

/** The first clip and the first skin of a binary glTF. */
export function glb(buffer) {
  const source = readGlb(buffer),
    { animations = [], skins = [] } = source.json,
    first = (all) => (all.length ? [0] : undefined);
  const { parents, rest, clips, skins: [skin], left } = readGltf(source, {
    animations: first(animations),
    skins: first(skins),
    error: false,
  });
  // What is in the file and not played is said.
  const more = [[animations, "animations"], [skins, "skins"]]
    .flatMap(([all, what]) => (all.length > 1 ? [`${all.length - 1} more ${what}`] : []));
  const keys = clips[0]?.keys ?? Float32Array.of(...rest, ...rest),
    rate = clips[0]?.rate ?? 30,
    joints = parents.length,
    missing = [...more, ...left],
    mesh = skin.primitives.length ? meshOf(skin) : undefined;
  const what = `${joints} joints, ${keys.length / 7 / joints} frames at ${Math.round(10 * rate) / 10} a second` +
    (mesh ? `, ${mesh.rest.length / 3} vertices` : "") +
    (missing.length ? `; not played: ${missing.join(", ")}` : "");
  return { parents, keys, seconds: 1 / rate, mesh, what };
}
