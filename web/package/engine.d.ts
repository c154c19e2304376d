/** Whether this engine has the instructions of a level. */
export function supports(level: "simd128" | "relaxed"): boolean;

/** The engine lacks the instructions of a level. */
export class LevelError extends Error {
  private constructor();
  readonly level: "simd128" | "relaxed";
}

/** What `dq8/relaxed` and `dq8/robots-relaxed` export. */
export interface Level<M extends string> {
  readonly module: M;
  readonly name: "relaxed";
}

export interface LoadOptions<M extends string = string> {
  /**
   * "simd128", the default, has the same bits on every machine. What `dq8/relaxed` exports multiplies and adds in one
   * rounding where the machine does; an engine that lacks the level throws `LevelError`.
   */
  level?: "simd128" | Level<M>;
  /** Whether "simd128" stands in for a level that the engine lacks. */
  fallback?: boolean;
  /** The bytes of the file, or what `compile` gave, if the package should not fetch it. */
  wasm?: ArrayBuffer | ArrayBufferView | object;
}
