// Clips in a quarter of their bytes, which `packedClip` of dq8 plays. The only file that knows what the module that
// packs exports.
import { compile as compileFile, LevelError, supports } from "./engine.js";
import { Module, Numbers, count } from "./memory.js";

const SIMD128 = { module: "dq8/pack", name: "simd128", url: () => new URL("./pack.simd128.wasm", import.meta.url) };

export const compile = ({ wasm } = {}, read) => compileFile(SIMD128, { wasm }, read);
/** A module of its own, with its own memory. */
export async function load(options, read) {
  const code = await compile(options, read);
  return new Packer((await WebAssembly.instantiate(code, {})).exports);
}
export { load as default, LevelError, supports };

/** Texts of errors, by the numbers that Rust has for them, and how many of clip, frame and joint each has. */
const FAULTS = {
  1: [3, (at, x) => `${at} has a rotation of length ${x}, not 1`],
  2: [3, (at, x) => `${at} is at ${x}, which no range of translations holds`],
  3: [1, (at, x) => `${at} has ${x} frames a second, which must be a positive number of 32 bits`],
  4: [0, () => "the clips have more keys than 32 bits count, or more tracks than 15 bits"],
};

/** Poses that no packed clip holds. */
export class PackError extends Error {
  constructor([fault, ...numbers]) {
    const [count, text] = FAULTS[fault] ?? [0, () => "the clips cannot be packed"],
      [clip, frame, joint] = numbers.slice(0, count);
    super(text(count === 3 ? `joint ${joint} in frame ${frame} of clip ${clip}` : `clip ${clip}`, numbers[3]));
    this.name = "PackError";
    this.clip = clip;
    this.frame = frame;
    this.joint = joint;
    this.value = count ? numbers[3] : undefined;
  }
}

/** What Rust is told of a clip: how many keys it has, its rate, and whether it loops. */
function head(joints, { keys, rate = 1, loops = false } = {}, clip) {
  const name = `clips[${clip}].keys`,
    length = keys?.length;
  if (length === undefined) throw new TypeError(`${name} is ${keys === undefined ? "missing" : "no array"}`);
  if (length === 0 || length % (7 * joints)) {
    throw new RangeError(`${name} holds ${length} numbers, which is not a multiple of ${7 * joints}, seven a joint`);
  }
  if (!(rate > 0 && rate < Infinity)) throw new RangeError(`clips[${clip}].rate is ${rate}, not a positive number`);
  return [length / 7, rate, +loops];
}

export class Packer {
  #module;
  constructor(raw) {
    this.#module = new Module(raw, "pack");
  }
  /** The bytes of clips of one skeleton, each of keys [frame][joint][x y z w tx ty tz]. */
  pack(joints, clips, { angle = 2e-5, length = 1e-5 } = {}) {
    if (count("joints", joints) === 0) throw new RangeError("joints is 0: a clip has a joint at least");
    if (!Array.isArray(clips)) throw new TypeError(`clips is ${clips === undefined ? "missing" : "no array"}`);
    if (clips.length === 0) throw new RangeError("clips is empty");
    for (const [name, limit] of Object.entries({ angle, length }))
      if (!(limit >= 0 && limit < Infinity)) throw new RangeError(`${name} is ${limit}, not a number from 0 on`);
    const m = this.#module,
      { raw } = m,
      made = [];
    const array = (Type, source) => {
      const numbers = new Numbers(m, Type, source);
      made.push(numbers);
      return numbers;
    };
    try {
      const heads = array(Float64Array, clips.flatMap((clip, i) => head(joints, clip, i)));
      const keys = array(Float32Array, clips.reduce((sum, { keys }) => sum + keys.length, 0)),
        fault = array(Float64Array, 5);
      let end = 0;
      for (const clip of clips) {
        keys.view.set(clip.keys, end);
        end += clip.keys.length;
      }
      const places = [heads.view.byteOffset, clips.length, keys.view.byteOffset, end / 7, fault.view.byteOffset, 1];
      const packed = raw.dq8_pack(joints, angle, length, ...places);
      if (packed === 0) throw new PackError(fault.view);
      try {
        return new Uint8Array(raw.memory.buffer, raw.dq8_packed_bytes(packed) >>> 0, raw.dq8_packed_length(packed))
          .slice();
      } finally {
        raw.dq8_packed_free(packed);
      }
    } finally {
      for (const numbers of made) numbers.free();
    }
  }
}
