/// <reference lib="esnext.disposable" />
/** A `Float32Array`, of the type that calls of it give: with a parameter from TypeScript 5.7 on. */
type View = ReturnType<typeof Float32Array.of>;

/** Numbers in the module's memory. */
export interface Floats {
  readonly length: number;
  /**
   * The numbers, without a copy. Take it again after anything that allocates: WebAssembly detaches old views when
   * memory grows.
   */
  readonly view: View;
  free(): void;
  [Symbol.dispose](): void;
}
