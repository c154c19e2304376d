import type { LoadOptions } from "./engine.js";
import type { Floats } from "./memory.js";
export { LevelError, supports } from "./engine.js";
export type { Floats, LoadOptions };

/** A module of its own, with its own memory: arrays of `dq8` are none of its. */
export function load(options?: LoadOptions<"dq8/robots">): Promise<Robots>;
export default load;
/** The compiled code, which can be posted to workers: `load({ wasm })` there. */
export function compile(options?: LoadOptions<"dq8/robots">): Promise<object>;

export interface Robots {
  floats(source: number | ArrayLike<number>): Floats;
  /** So many identities, or the numbers of an array. */
  motions(source: number | ArrayLike<number>): Floats;
  /** A robot of the text or the bytes of a URDF file. Throws with the line where something is wrong. */
  robot(urdf: string | ArrayBuffer | Uint8Array): Robot;
}

export type Outcome = "converged" | "outOfReach" | "atLimits" | "stalled" | "unfinished" | "invalid";
export const OUTCOMES: readonly Outcome[];

export interface Report {
  outcome: Outcome;
  iterations: number;
  restarts: number;
  /** Radians. */
  angularError: number;
  linearError: number;
}

export interface Robot {
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
  /** Moves `values` until `link` is at `target`, a motion; a link is given by its number or name. */
  reach(
    link: number | string,
    target: Floats,
    values: Floats,
    options?: { position?: boolean; restarts?: boolean },
  ): Report;
  free(): void;
  [Symbol.dispose](): void;
}
