import type { LoadOptions } from "./engine.js";
import { Floats, Handle } from "./memory.js";
export { LevelError, supports } from "./engine.js";
export { Floats, type LoadOptions };

/** A module of its own, with its own memory. */
export function load(options?: LoadOptions<"dq8">): Promise<Dq8>;
export default load;
/** The compiled code, which can be posted to workers: `load({ wasm })` there. */
export function compile(options?: LoadOptions<"dq8">): Promise<object>;

/**
 * Motions are eight numbers each, x y z w of the rotation and of the dual part; all errors are thrown before anything
 * is written.
 */
export class Dq8 {
  private constructor();
  floats(source: number | ArrayLike<number>): Floats;
  /** So many identities, or the numbers of an array. */
  motions(source: number | ArrayLike<number>): Floats;
  /** Locals in an array as poses that can be blended and added; the array is read when they are. */
  poses(locals: Floats): Sampled;
  /** A skeleton of parents that come before their children; -1 for none. */
  skeleton(parents: ArrayLike<number>): Skeleton;
  /** Packed clips, of bytes that dq8/pack, Rust, C or Python wrote, copied. */
  packedClip(bytes: ArrayBufferLike | ArrayLike<number>): PackedClip;
  skin(options: SkinOptions): Skin;
  /** Motions of [x y z w tx ty tz] each. */
  fromRotationsTranslations(poses: Floats, motions: Floats): void;
  /** [x y z w tx ty tz] of unit motions. */
  toRotationsTranslations(motions: Floats, poses: Floats): void;
  /** Inverses of unit motions. */
  inverse(motions: Floats, inverses: Floats): void;
  /** product[i] = a[i] * b[i]: b acts first. One motion in `a` is the parent of all. */
  mul(a: Floats, b: Floats, product: Floats): void;
  /** From a[i] to b[i], t[i] of it, along one screw. */
  sclerpEach(a: Floats, b: Floats, t: Floats, between: Floats): void;
  /** All points by one motion. */
  transformPoints(motion: Floats, points: Floats, moved: Floats): void;
  transformPointsEach(motions: Floats, points: Floats, moved: Floats): void;
  /** 4×4 matrices by columns: what WebGL, WebGPU and three.js read. */
  matrices(motions: Floats, matrices: Floats): void;
}

export class Skeleton extends Handle {
  private constructor();
  readonly joints: number;
  /**
   * A clip of keys [frame][joint][x y z w tx ty tz], copied. Its times are frames, or seconds with a rate in frames a
   * second; one that loops ends with its first frame once more.
   */
  clip(keys: ArrayLike<number>, options?: { rate?: number; loops?: boolean }): Clip;
  /** Poses in blocks of four instances: the quickest form where nothing else wants them plain. */
  crowd(instances: number): Crowd;
  /**
   * Locals [instance][joint] of sampled clips: to turn a head or to take the motion of a root, and then as locals
   * again.
   */
  locals(poses: Sampled, locals: Floats): void;
  /** The locals of models, as after a simulation; with the roots that the models have. */
  modelToLocal(models: Floats, locals: Floats, options?: { roots?: Floats }): void;
  /**
   * `roots` are a motion for each instance, or one for all. Model poses [instance][joint] of locals or of sampled
   * clips; over the locals themselves without `models`.
   */
  localToModel(locals: Floats, models?: Floats, options?: { roots?: Floats }): void;
  localToModel(poses: Sampled, models: Floats, options?: { roots?: Floats }): void;
  /** Skinning palettes [instance][joint], 4×4 matrices by columns. */
  palette(poses: Floats | Sampled, options: { roots?: Floats; inverseBinds: Floats; palette: Floats }): void;
  /** The same of models, after something has changed them. */
  modelPalette(models: Floats, options: { inverseBinds: Floats; palette: Floats }): void;
  /** Takes the end of a limb [hip, knee, foot] to the target of each instance, its knee toward the pole. */
  twoBone(limb: readonly [number, number, number], models: Floats, targets: Floats, poles: Floats): void;
}

export class Clip extends Handle {
  private constructor();
  /** The time from the first frame to the last. */
  readonly duration: number;
  readonly frames: number;
  /**
   * Its poses, instance i at the time at[i], or all at one time; held at both ends if it does not loop. Between two
   * frames rotations are normalized means (NLERP): of frames that are an angle θ apart, within θ³/249 of slerp, which
   * is 4e-6 for 0.1 radians.
   */
  sample(at: number | Floats): Sampled;
}

/** Clips of one skeleton in 8 bytes for each track that moves, and frame. */
export class PackedClip extends Handle {
  private constructor();
  /** How many clips there are. */
  readonly clips: number;
  /** How many frames one of them has; 0 if there is none of this number. */
  frames(clip?: number): number;
  /**
   * The time from the first frame of one of them to its last, in seconds if it has a rate; 0 if there is none of this
   * number.
   */
  duration(clip?: number): number;
  /**
   * Poses, instance i at the time at[i] of clip clips[i], or all of one clip, the first if none is given. Held at both
   * ends if the clip does not loop.
   */
  sample(at: number | Floats, clips?: number | Floats): Sampled;
}

/**
 * Poses that are made as they are loaded, of plain clips, of packed ones, or of an array. What blends and adds can be
 * blended and added again.
 */
export class Sampled {
  private constructor();
  /**
   * From these to those of a layer, by a weight for each instance, or one for all, times one for each joint. The law is
   * "nlerp" for rotations, the normalized mean, where none is given. "slerp" turns at constant speed, as three.js does,
   * and takes longer; between poses that are 90° apart the two differ by up to 0.92°.
   */
  blend(layer: Sampled, weights: number | Floats, options?: { mask?: Floats; law?: "nlerp" | "slerp" }): Sampled;
  /** These, then so much of those of a layer on top: its rotations from the left, its translations added. */
  add(layer: Sampled, weights: number | Floats, options?: { mask?: Floats }): Sampled;
}

export class Crowd extends Handle {
  private constructor();
  set(poses: Floats): void;
  /** In place. */
  localToModel(): void;
  /** Skinning palettes [instance][joint] of models, 4×4 matrices by columns. */
  palette(options: { inverseBinds: Floats; palette: Floats }): void;
  copyTo(poses: Floats): void;
}

export interface SkinOptions {
  jointCount: number;
  influences: number;
  /** [vertex][influence], copied, as the weights are. */
  joints: ArrayLike<number>;
  weights: ArrayLike<number>;
}

export class Skin extends Handle {
  private constructor();
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
