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
  4: [0, () => "the clips have more keys than 32 bits count, or more tracks than 15 bits count"],
};

/** Clips that the format of packed clips does not hold. The declarations list the reasons. */
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

/** A number that fits. */
function number(name, value, fits, kind) {
  if (typeof value !== "number") throw new TypeError(`${name} is ${value}, not a ${kind}`);
  if (!fits || value === Infinity) throw new RangeError(`${name} is ${value}, not a ${kind}`);
  return value;
}

/** A value that is an object, of the kind that is needed. */
function object(name, value, kind = "object", fits = true) {
  if (fits && typeof value === "object" && value) return value;
  throw new TypeError(`${name} is ${value === undefined ? "missing" : `no ${kind}`}`);
}

/** The keys of a clip, and its head for Rust: the number of keys, the rate, and 1 if the clip loops. */
function read(joints, clip, index) {
  const { keys, rate = 1, loops } = object(`clips[${index}]`, clip),
    name = `clips[${index}].keys`;
  // Arrays of dq8 have a length, too, and their numbers in `view`.
  const fits = !(keys instanceof Numbers) && (keys?.length === 0 || typeof keys?.[0] === "number"),
    { length } = object(name, keys, "array of numbers", fits);
  if (length === 0) throw new RangeError(`${name} is empty, or a view from before memory has grown`);
  if (length % (7 * joints)) {
    throw new RangeError(`${name} holds ${length} numbers, which is not a multiple of ${7 * joints}, seven a joint`);
  }
  return { keys, head: [length / 7, number(`clips[${index}].rate`, rate, rate > 0, "positive number"), +!!loops] };
}

export class Packer {
  #module;
  constructor(raw) {
    this.#module = new Module(raw, "pack");
  }
  /** The bytes of clips of one skeleton, each of keys [frame][joint][x y z w tx ty tz]. */
  pack(joints, clips, limits = {}) {
    if (count("joints", joints) === 0) throw new RangeError("joints is 0");
    object("clips", clips, "array", Array.isArray(clips));
    if (clips.length === 0) throw new RangeError("clips is empty");
    const { angle = 2e-5, length = 1e-5 } = object("limits", limits);
    for (const [name, limit] of Object.entries({ angle, length }))
      number(`limits.${name}`, limit, limit >= 0, "number from 0 on");
    // Not `map`, which passes over holes of the array.
    const all = Array.from(clips, (clip, index) => read(joints, clip, index));
    const m = this.#module,
      { raw } = m,
      made = [];
    const array = (Type, source) => {
      const numbers = new Numbers(m, Type, source);
      made.push(numbers);
      return numbers;
    };
    try {
      const heads = array(Float64Array, all.flatMap(({ head }) => head)),
        keys = array(Float32Array, all.reduce((sum, { keys }) => sum + keys.length, 0)),
        fault = array(Float64Array, 5);
      let end = 0;
      for (const clip of all) {
        keys.view.set(clip.keys, end);
        end += clip.keys.length;
      }
      const at = (numbers) => numbers.view.byteOffset,
        packed = raw.dq8_pack(joints, angle, length, at(heads), all.length, at(keys), end / 7, at(fault), 1);
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
