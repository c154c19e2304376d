// Arrays in a module's memory, as callers make them.
import { Numbers } from "./memory.js";
import { loud } from "./loud.js";

loud(Numbers);

/** Numbers: so many zeros, or those of an array. */
export function floats(module, source) {
  if (source instanceof Numbers) {
    const made = new Numbers(module, Float32Array, source.length);
    made.view.set(source.view);
    return made;
  }
  const bad = Array.isArray(source) ? source.findIndex((x) => typeof x !== "number") : -1;
  if (bad >= 0) throw new TypeError(`source[${bad}] is no number`);
  // A view of this memory would be empty once the memory has grown for the copy.
  const own = ArrayBuffer.isView(source) && source.buffer === module.raw.memory.buffer;
  return new Numbers(module, Float32Array, own ? source.slice() : source);
}

/** Motions, eight numbers each: so many identities, or those of an array. */
export function motions(module, source) {
  if (typeof source !== "number") return floats(module, source);
  const made = floats(module, 8 * source);
  for (let view = made.view, i = 3; i < view.length; i += 8) view[i] = 1;
  return made;
}
