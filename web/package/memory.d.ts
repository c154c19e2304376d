/// <reference lib="esnext.disposable" />
/** A `Float32Array`, of the type that calls of it give: with a parameter from TypeScript 5.7 on. */
type View = ReturnType<typeof Float32Array.of>;

/** What lives in the module's memory until it is freed, or to the end of a block that says `using`. */
export abstract class Handle {
  protected constructor();
  free(): void;
  [Symbol.dispose](): void;
}

/** Numbers in the module's memory. */
export class Floats extends Handle {
  private constructor();
  readonly length: number;
  /**
   * The numbers, without a copy. Take it again after anything that allocates: WebAssembly detaches old views when
   * memory grows.
   */
  readonly view: View;
  /**
   * The numbers from `begin` to before `end`, without a copy: a batch of instances. They are those of this array, and
   * are freed with it.
   */
  subarray(begin?: number, end?: number): Floats;
}
