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
  return new Numbers(module, Float32Array, source);
}

/** Motions, eight numbers each: so many identities, or those of an array. */
export function motions(module, source) {
  if (typeof source !== "number") return floats(module, source);
  const made = floats(module, 8 * source);
  for (let view = made.view, i = 3; i < view.length; i += 8) view[i] = 1;
  return made;
}
