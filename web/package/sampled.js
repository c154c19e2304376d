// Poses that are made as they are loaded: of a clip, of an array, or of one over another, as deep
// as one likes.
import { Numbers, count } from "./memory.js";

/** Words of `Playing` and of `Source` in Rust. */
const PLAYING = 6;
const WORDS = 2 * PLAYING + 7;
/** Where in `Source` the place of locals is. */
export const LOCALS = WORDS - 2;
const LAWS = { nlerp: 0, slerp: 1 },
  ADDS = 2;

export class Sampled {
  #leaf;
  #over;
  /**
   * A leaf has { module, place, at, clips } or { module, locals }; `over` has { layer, weights,
   * mask, kind }.
   */
  constructor(leaf, over) {
    this.#leaf = leaf;
    this.#over = over;
  }
  #with(layer, weights, mask, kind) {
    if (!(layer instanceof Sampled)) throw new TypeError("layer is neither a sample nor dq8.poses");
    return new Sampled(this, { layer, weights, mask, kind });
  }
  /**
   * From these poses to those of a layer, by a weight for each instance, times one for each joint.
   */
  blend(layer, weights, { mask, law = "nlerp" } = {}) {
    if (!Object.hasOwn(LAWS, law)) throw new RangeError(`law is ${law}, none of ${Object.keys(LAWS).join(", ")}`);
    return this.#with(layer, weights, mask, LAWS[law]);
  }
  /** These poses, then so much of those of a layer on top. */
  add(layer, weights, { mask } = {}) {
    return this.#with(layer, weights, mask, ADDS);
  }

  /** All arrays that it reads, by name. */
  *#arrays(before = "") {
    if (!this.#over) {
      for (const name of ["at", "clips", "locals"])
        if (this.#leaf[name] instanceof Numbers) yield [before + name, this.#leaf[name]];
      return;
    }
    const { layer, weights, mask } = this.#over,
      below = this.#leaf;
    yield* below.#arrays(below.#over ? `${before}base.` : before);
    yield* layer.#arrays(`${before}layer.`);
    for (const [name, numbers] of [
      ["weights", weights],
      ["mask", mask],
    ])
      if (numbers instanceof Numbers) yield [before + name, numbers];
  }
  arrays() {
    return Object.fromEntries(this.#arrays());
  }

  /** Words of `Playing`; what is no clip goes to a slot of scratch first. */
  #playing(module, scratch, slot, before) {
    if (this.#over) return scratch.layer(slot, (words) => this.#words(module, scratch, slot, before, words));
    const { place, at, clips, locals } = this.#leaf,
      name = before ? "layer" : "clip";
    if (this.#leaf.module !== module) throw new TypeError(`${place ? name : "locals"} is of another module`);
    if (!place) return scratch.poses(slot, locals, `${before}locals`);
    const times = scratch.each(at, `${before}at`);
    return [
      place(name),
      ...times,
      ...(typeof clips === "number" ? [0, 0, count("clips", clips)] : [...module.array(`${before}clips`, clips), 0]),
    ];
  }
  /** Words of `Source`. A layer keeps its slot while the one above it fills the next. */
  #words(module, scratch, slot, before, words) {
    if (!this.#over) return words(this.#playing(module, scratch, slot, before));
    const { layer, weights, mask, kind } = this.#over,
      below = this.#leaf;
    const base = below.#playing(module, scratch, slot, below.#over ? `${before}base.` : before);
    const above = layer.#playing(module, scratch, slot + 1, `${before}layer.`);
    return words([
      ...base,
      ...above,
      ...scratch.each(weights, `${before}weights`),
      ...module.maybe(`${before}mask`, mask),
      kind,
    ]);
  }
  /** Calls with the words of `Source`. */
  write(module, scratch, words) {
    return this.#words(module, scratch, 0, "", words);
  }
}

/**
 * Arrays of a skeleton that layers below the last, and numbers for all instances, are written to.
 */
export class Scratch {
  #module;
  #joints;
  #skeleton;
  #words;
  #layers = [];
  #each = [];
  #used = 0;
  #instances = 0;
  #errors;
  constructor(module, joints, skeleton) {
    this.#module = module;
    this.#joints = joints;
    this.#skeleton = skeleton;
    this.#words = new Numbers(module, Uint32Array, WORDS);
  }
  free() {
    for (const numbers of [this.#words, ...this.#layers, ...this.#each]) numbers?.free();
  }
  /**
   * Calls with the place of words that `source` writes, or that say where locals are; errors are
   * worded by `errors`.
   */
  run(source, instances, call, errors) {
    this.#used = 0;
    this.#instances = instances;
    this.#errors = errors;
    return source.write(this.#module, this, (words) => call(this.words(words)));
  }
  #check(status) {
    if (status !== 0) throw this.#module.error(this.#errors.sizes, this.#errors);
  }
  words(words, at = 0) {
    const view = this.#words.view;
    view.fill(0);
    view.set(words, at);
    return view.byteOffset;
  }
  /** An array of so many numbers, the same as in the frame before. */
  #take(arrays, i, length) {
    if (arrays[i]?.length !== length) {
      arrays[i]?.free();
      arrays[i] = new Numbers(this.#module, Float32Array, length);
    }
    return arrays[i];
  }
  #slot(slot) {
    return this.#take(this.#layers, slot, 7 * this.#joints * this.#instances);
  }
  #stored(slot) {
    return [0, this.#layers[slot].view.byteOffset, this.#joints * this.#instances, 0, 0, 0];
  }
  /** Place and count of numbers for each instance, of which one may stand for all. */
  each(numbers, name) {
    if (typeof numbers !== "number") return this.#module.array(name, numbers);
    const all = this.#take(this.#each, this.#used++, this.#instances);
    all.view.fill(numbers);
    return this.#module.array(name, all);
  }
  /** Locals as rotations and translations. */
  poses(slot, locals, name) {
    const length = this.#joints * this.#instances,
      [at, found] = this.#module.array(name, locals, 8);
    if (found !== length) throw new RangeError(`${name} holds ${found} motions where ${length} are needed`);
    const poses = this.#slot(slot);
    this.#check(this.#module.raw.dq8_to_rotations_translations(at, found, poses.view.byteOffset, found));
    return this.#stored(slot);
  }
  /** The poses of layers, as one. */
  layer(slot, write) {
    return write((words) => {
      const poses = this.#slot(slot),
        to = [poses.view.byteOffset, poses.length / 7];
      this.#check(this.#module.raw.dq8_skeleton_layer(this.#skeleton(), this.words(words), ...to));
      return this.#stored(slot);
    });
  }
}
