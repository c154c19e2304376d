import type { LoadOptions } from "./engine.js";
import type { Floats } from "./memory.js";
export { LevelError, supports } from "./engine.js";
export type { Floats, LoadOptions };

/** A module of its own, with its own memory. */
export function load(options?: LoadOptions<"dq8">): Promise<Dq8>;
export default load;
/** The compiled code, which can be posted to workers: `load({ wasm })` there. */
export function compile(options?: LoadOptions<"dq8">): Promise<object>;

interface Freed {
  free(): void;
  [Symbol.dispose](): void;
}

/** Motions are eight numbers each, x y z w of the rotation and of the dual part; all errors are thrown before anything is written. */
export interface Dq8 {
  floats(source: number | ArrayLike<number>): Floats;
  /** So many identities, or the numbers of an array. */
  motions(source: number | ArrayLike<number>): Floats;
  /** A skeleton of parents that come before their children; -1 for none. */
  skeleton(parents: ArrayLike<number>): Skeleton;
  /** Packed clips, of bytes that Rust, Python or the example mocap wrote, copied. */
  packedClip(bytes: ArrayBufferLike | ArrayLike<number>): PackedClip;
  skin(options: SkinOptions): Skin;
  /** Motions of [x y z w tx ty tz] each. */
  fromRotationsTranslations(poses: Floats, motions: Floats): void;
  /** product[i] = a[i] * b[i]: b acts first. */
  mul(a: Floats, b: Floats, product: Floats): void;
  /** From a[i] to b[i], t[i] of it, along one screw. */
  sclerpEach(a: Floats, b: Floats, t: Floats, between: Floats): void;
  transformPointsEach(motions: Floats, points: Floats, moved: Floats): void;
  /** 4×4 matrices by columns: what WebGL, WebGPU and three.js read. */
  matrices(motions: Floats, matrices: Floats): void;
}

export interface Skeleton extends Freed {
  readonly joints: number;
  /**
   * A clip of keys [frame][joint][x y z w tx ty tz], copied. Its times are frames, or seconds with a rate in frames a second; one
   * that loops ends with its first frame once more.
   */
  clip(keys: ArrayLike<number>, options?: { rate?: number; loops?: boolean }): Clip;
  /** Poses in blocks of four instances: the quickest form where nothing else wants them plain. */
  crowd(instances: number): Crowd;
  /** Model poses [instance][joint] of locals or of sampled clips; over the locals themselves without `models`. */
  localToModel(locals: Floats, models?: Floats, options?: { roots?: Floats }): void;
  localToModel(poses: Sampled, models: Floats, options?: { roots?: Floats }): void;
  /** Skinning palettes [instance][joint], 4×4 matrices by columns. */
  palette(poses: Floats | Sampled, options: { roots?: Floats; inverseBinds: Floats; palette: Floats }): void;
  /** The same of models, after something has changed them. */
  modelPalette(models: Floats, options: { inverseBinds: Floats; palette: Floats }): void;
  /** Takes the end of a limb [hip, knee, foot] to the target of each instance, its knee toward the pole. */
  twoBone(limb: readonly [number, number, number], models: Floats, targets: Floats, poles: Floats): void;
}

export interface Clip extends Freed {
  /** The time from the first frame to the last. */
  readonly duration: number;
  /** Its poses, instance i at the time at[i]; held at both ends if it does not loop. */
  sample(at: Floats): Sampled;
}

/** Clips of one skeleton in 8 bytes for each track that moves, and frame. */
export interface PackedClip extends Freed {
  /** How many clips there are. */
  readonly clips: number;
  /** How many frames one of them has; 0 if there is none of this number. */
  frames(clip?: number): number;
  /** The time from the first frame of one of them to its last, in seconds if it has a rate; 0 if there is none of this number. */
  duration(clip?: number): number;
  /**
   * Poses, instance i at the time at[i] of clip clips[i], or all of one clip, the first if none is given. Held at both ends if the
   * clip does not loop.
   */
  sample(at: Floats, clips?: number | Floats): Sampled;
}

/** Poses that are made as they are loaded, of plain clips or packed ones. */
export interface Sampled {
  /** From these to those of another clip, by a weight for each instance, times one for each joint. */
  blend(layer: Sampled, weights: Floats, options?: { mask?: Floats }): Sampled;
  /** These, then so much of those of another clip on top. */
  add(layer: Sampled, weights: Floats, options?: { mask?: Floats }): Sampled;
}

export interface Crowd extends Freed {
  set(poses: Floats): void;
  /** In place. */
  localToModel(): void;
  copyTo(poses: Floats): void;
}

export interface SkinOptions {
  jointCount: number;
  influences: number;
  /** [vertex][influence], copied, as the weights are. */
  joints: ArrayLike<number>;
  weights: ArrayLike<number>;
}

export interface Skin extends Freed {
  pose(options: {
    blend?: "dual" | "linear" | "mixed";
    /** A motion for each joint. */
    motions: Floats;
    /** How much of "mixed" is "dual", for each vertex. */
    shares?: Floats;
    rest: Floats;
    posed: Floats;
    normals?: Floats;
    posedNormals?: Floats;
  }): void;
}
