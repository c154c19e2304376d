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

/**
 * A track whose frames all lie within its limit of the first frame is kept as this frame alone, so it is off by up to
 * the limit more. A joint that no clip moves by more than `length` along any axis stays in the middle of its places.
 */
export interface PackLimits {
  /**
   * The limit of rotations, in radians; 2e-5 if it is not given, which is less than what a key of 16 bits loses. An
   * angle a is measured as 4 sin(a/4), which is 0.1 % less than 0.3 radians.
   */
  angle?: number;
  /** The limit of translations along each axis, in their unit; 1e-5 if it is not given. */
  length?: number;
}

export class Packer {
  private constructor();
  /**
   * The bytes of clips of one skeleton, which `dq8.packedClip` plays, and Rust, C and Python: the same on every
   * machine, and those that Rust writes. A key is 8 bytes in place of 28, and a track that does not move has one.
   *
   * At frames, a rotation is off by at most 5.4e-5 radians, and each coordinate of a translation by at most 1/131068 of
   * the longest side of the box in which its joint moves in all clips, and by the rounding of 32-bit numbers. So a root
   * that walks far is better given as `roots`. A track that is kept as one key is off by up to its limit more.
   * Throws `PackError`.
   */
  pack(joints: number, clips: readonly PackedSource[], limits?: PackLimits): Uint8Array;
}

/**
 * Clips that the format of packed clips does not hold. There are four reasons: a rotation is not unit; a coordinate of
 * a translation is not finite, or is farther from another one of its joint than 32-bit numbers reach; a rate is not a
 * positive 32-bit number; or there are more keys or tracks than the format counts.
 */
export class PackError extends Error {
  private constructor();
  /** The place of the error. A rate has no frame and no joint; too many keys or tracks have no place. */
  readonly clip: number | undefined;
  readonly frame: number | undefined;
  readonly joint: number | undefined;
  /** The wrong number: the length of a rotation, a coordinate of a translation, or a rate. */
  readonly value: number | undefined;
}
