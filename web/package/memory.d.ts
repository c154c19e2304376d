/** Numbers in the module's memory. */
export interface Floats {
  readonly length: number;
  /** The numbers, without a copy. Take it again after anything that allocates: WebAssembly detaches old views when memory grows. */
  readonly view: Float32Array<ArrayBuffer>;
  free(): void;
  [Symbol.dispose](): void;
}

export interface LoadOptions {
  /** "simd128", the default, has the same bits on every machine; "relaxed" multiplies and adds in one rounding where the machine does. */
  level?: "simd128" | "relaxed";
  /** The file, if the package should not fetch it. */
  wasm?: BufferSource | WebAssembly.Module;
}
