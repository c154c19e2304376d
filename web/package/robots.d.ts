import type { LoadOptions } from "./engine.js";
import { Floats, Handle } from "./memory.js";
export { LevelError, supports } from "./engine.js";
export { Floats, type LoadOptions };

/** A module of its own, with its own memory: arrays of `dq8` are none of its. */
export function load(options?: LoadOptions<"dq8/robots">): Promise<Robots>;
export default load;
/** The compiled code, which can be posted to workers: `load({ wasm })` there. */
export function compile(options?: LoadOptions<"dq8/robots">): Promise<object>;

export class Robots {
  private constructor();
  floats(source: number | ArrayLike<number>): Floats;
  /** So many identities, or the numbers of an array. */
  motions(source: number | ArrayLike<number>): Floats;
  /** A robot of the text or the bytes of a URDF file. Throws with the line where something is wrong. */
  robot(urdf: string | ArrayBuffer | Uint8Array, options?: RobotOptions): Robot;
}

export interface RobotOptions {
  /**
   * Whether the base moves freely: the rotation x y z w and the translation of the root come before all other values,
   * and six rates before all others.
   */
  floating?: boolean;
  /** The pose of the root, if it stands elsewhere than at the origin. */
  base?: Floats;
  /** Links that the file does not have, each fixed at a pose in the frame of another link. */
  tools?: readonly { name: string; link: string; pose: Floats }[];
}

export type Outcome = "converged" | "outOfReach" | "atLimits" | "stalled" | "unfinished" | "invalid";
export const OUTCOMES: readonly Outcome[];

export interface ReachOptions {
  /** Whether the position of the target counts alone. */
  position?: boolean;
  /** Whether a search that is stuck begins again elsewhere, as it does without this option. */
  restarts?: boolean;
}

export interface Report {
  outcome: Outcome;
  iterations: number;
  restarts: number;
  /** Radians. */
  angularError: number;
  linearError: number;
}

/** Values of a whole configuration: those of the six hinges are found, the others as they were given. */
export interface Solution {
  values: Float32Array;
  /** The root of the sum of the squared differences to the given values, radians. */
  distance: number;
  /** Where two solutions coincide, or infinitely many are. */
  singular: { shoulder: boolean; elbow: boolean; wrist: boolean };
}

export interface Solutions {
  family: "sphericalWrist" | "threeParallel" | "other";
  /** Whether there are no others: arms of the family "other" are searched. */
  isComplete: boolean;
  /** Those nearest to the given values first, within the limits. */
  found: Solution[];
}

/** Links are given by their numbers or names. */
export class Robot extends Handle {
  private constructor();
  readonly linkNames: readonly string[];
  readonly valueNames: readonly string[];
  /** The link that each link hangs from; -1 for the root. */
  readonly parents: readonly number[];
  /** [lower, upper] of each value, infinite where there is none. */
  readonly valueLimits: readonly (readonly [number, number])[];
  /** What the file holds and is not read. */
  readonly warnings: readonly string[];
  readonly rates: number;
  link(name: string): number | undefined;
  /** [configuration][value] to [configuration][link]. */
  poses(values: Floats, poses: Floats): void;
  /** [configuration][rate] of six numbers, angular first, in the axes of the world. */
  jacobians(link: number | string, values: Floats, columns: Floats): void;
  /** Moves `values` until `link` is at `target`, a motion. */
  reach(link: number | string, target: Floats, values: Floats, options?: ReachOptions): Report;
  /** The same for many configurations, four at a time: a target, and values to start from, for each. */
  reachEach(link: number | string, targets: Floats, values: Floats, options?: ReachOptions): Report[];
  /**
   * The same for targets that move: each search goes on from the values of the call before, and never begins elsewhere.
   */
  follow(link: number | string, targets: Floats, values: Floats, options?: { position?: boolean }): Report[];
  /** All values that bring a link of an arm of six hinges to `target`. */
  solutions(link: number | string, target: Floats, values: Floats): Solutions;
}
