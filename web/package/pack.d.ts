import type { LoadOptions } from "./engine.js";
export { LevelError, supports } from "./engine.js";

/** What a module that packs is made of, if the package should not fetch it. It has no level but simd128. */
export type PackLoadOptions = Pick<LoadOptions<"dq8/pack">, "wasm">;

/** A module of its own, with its own memory: 15 kB that only pages need which make files. */
export function load(options?: PackLoadOptions): Promise<Packer>;
export default load;
/** The compiled code, which can be posted to workers: `load({ wasm })` there. */
export function compile(options?: PackLoadOptions): Promise<object>;

/** A clip as `readGltf` and `readThree` give it, and as `skeleton.clip` takes it. */
export interface PackedSource {
  /** [frame][joint][x y z w tx ty tz]: unit rotations, and translations. */
  keys: ArrayLike<number>;
  /** Frames a second; times are frames without a rate. */
  rate?: number;
  /** Whether the clip loops, and so ends with its first frame once more. */
  loops?: boolean;
}

/** A track that changes within a clip by no more than its limit is kept as one key. */
export interface PackLimits {
  /** Of rotations, in radians; 2e-5 if it is not given, which is less than what a key of 16 bits loses. */
  angle?: number;
  /** Of translations, in their unit; 1e-5 if it is not given. */
  length?: number;
}

export class Packer {
  private constructor();
  /**
   * The bytes of clips of one skeleton, which `dq8.packedClip` plays, and Rust, C and Python: the same on every
   * machine, and those that Rust writes. A key is 8 bytes in place of 28, and a track that does not move has one. A
   * rotation is within 4e-5 radians at frames; a translation within 1/131068 of the longest side of the box in which
   * its joint moves in all clips, so a root that walks far is better given as `roots`. Throws `PackError`.
   */
  pack(joints: number, clips: readonly PackedSource[], limits?: PackLimits): Uint8Array;
}

/** Poses that no packed clip holds: a rotation that is not unit, or a number that is not finite. */
export class PackError extends Error {
  private constructor();
  /** Where it is; undefined where the error is of all clips together. */
  readonly clip: number | undefined;
  readonly frame: number | undefined;
  readonly joint: number | undefined;
  /** What is wrong: the length of a rotation, a component of a translation, or a rate. */
  readonly value: number | undefined;
}
