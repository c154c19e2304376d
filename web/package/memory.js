// Arrays in the memory of a module, and what all nouns share: arguments become places, numbers become errors.

const text = new TextDecoder();
/** So that `using` frees what has it; older engines have `free` alone. */
export const dispose = Symbol.dispose ?? Symbol("dispose");

/** What elements are, by how many numbers each has. */
const UNITS = {
  1: ["number", "numbers"], 3: ["point", "points"], 6: ["column", "columns"], 7: ["pose", "poses"],
  8: ["motion", "motions"], 16: ["matrix", "matrices"],
};

/**
 * Rust's text in the words of the call: the names of its arguments, where Rust has others, what their elements are, and
 * what there is a number of in `each` instance.
 */
function worded(text, sizes = {}, { names = {}, each } = {}) {
  const unit = (name, n) => (UNITS[sizes[name]] ?? ["element", "elements"])[n === "1" || n === "no" ? 0 : 1];
  return text.replace(/\b[a-z]+(?:_[a-z]+)+\b/g, (name) => name.replace(/_(.)/g, (_, c) => c.toUpperCase()))
    .replace(/^[\w ]+?(?= holds )/, (name) => names[name] ?? name)
    .replace(/^(\w+) holds (\w+) elements?/, (_, name, n) => `${name} holds ${n} ${unit(name, n)}`)
    .replace(/(multiple of the \d+) joint/, each ? `$1 ${each}` : "$&");
}

/** Numbers in a module's memory. */
export class Numbers {
  #module; #Type; #view; #at; #length; #whole;
  constructor(module, Type, source) {
    const length = typeof source === "number" ? source : source?.length;
    if (length === undefined) throw new TypeError(`source is ${source}, neither a number nor an array`);
    if (!(Number.isInteger(length) && length >= 0)) throw new RangeError(`length is ${length}, not a whole number`);
    // A view of this memory would be empty once the memory has grown for the copy.
    if (source.buffer === module.raw.memory.buffer) source = source.slice();
    this.#module = module; this.#Type = Type; this.#length = length;
    const bytes = length * Type.BYTES_PER_ELEMENT;
    this.#at = bytes < 2 ** 31 ? module.raw.dq8_allocate(bytes) >>> 0 : 0;
    if (this.#at === 0) throw new RangeError(`there is no memory for ${length} numbers`);
    if (typeof source === "number") return;
    try { this.view.set(source); } catch (error) {
      this.free();
      throw length ? error : new TypeError("source is a view from before memory has grown: take .view again");
    }
  }
  get length() { return this.#length; }
  /** Numbers from `begin` to before `end`, without a copy, for as long as these are there. */
  subarray(begin = 0, end = this.#length) {
    this.#check("the array");
    if (count("begin", begin) > count("end", end) || end > this.#length) {
      throw new RangeError(`${begin} to ${end} is no part of ${this.#length} numbers`);
    }
    const part = new Numbers(this.#module, this.#Type, 0);
    part.free();
    part.#at = this.#at + begin * this.#Type.BYTES_PER_ELEMENT;
    part.#length = end - begin;
    part.#whole = this;
    return part;
  }
  /** The numbers, without a copy. Take it again after anything that allocates, which may move all memory. */
  get view() {
    this.#check("the array");
    const { buffer } = this.#module.raw.memory;
    if (this.#view?.buffer !== buffer) this.#view = new this.#Type(buffer, this.#at, this.#length);
    return this.#view;
  }
  free() {
    if (this.#at && !this.#whole) this.#module.raw.dq8_free(this.#at, this.#length * this.#Type.BYTES_PER_ELEMENT);
    this.#at = this.#length = 0;
    this.#view = undefined;
  }
  [dispose]() { this.free(); }
  /** Whether they, or what they are a part of, have been freed. */
  get #freed() { return this.#at === 0 || (this.#whole?.#freed ?? false); }
  #check(name) { if (this.#freed) throw new Error(`${name} has been freed`); }
  /** Whether they share numbers. */
  static overlap(a, b) {
    const [first, next] = a.#at < b.#at ? [a, b] : [b, a];
    const end = first.#at + first.#length * first.#Type.BYTES_PER_ELEMENT;
    return a.#module === b.#module && !a.#freed && !b.#freed && next.#length > 0 && next.#at < end;
  }
  /** Place and count of an array of things of `size` numbers. */
  static place(module, name, numbers, size) {
    if (numbers === undefined || numbers === null) throw new TypeError(`${name} is missing`);
    if (!(numbers instanceof Numbers) || numbers.#Type !== Float32Array) {
      throw new TypeError(`${name} is no array of ${module.name}.floats`);
    }
    if (numbers.#module !== module) throw new TypeError(`${name} is an array of another module`);
    numbers.#check(name);
    if (numbers.#length % size) {
      throw new RangeError(`${name} holds ${numbers.#length} numbers, which is not a multiple of ${size}`);
    }
    return [numbers.#at, numbers.#length / size];
  }
}

/** An instance of a module. */
export class Module {
  raw; name;
  constructor(raw, name) { this.raw = raw; this.name = name; }
  string(at, length) { return text.decode(new Uint8Array(this.raw.memory.buffer, at >>> 0, length)); }
  error(sizes, words) {
    return new Error(worded(this.string(this.raw.dq8_error(), this.raw.dq8_error_length()), sizes, words));
  }
  /** The place of what has been made. */
  made(at, sizes, words) { if (at === 0) throw this.error(sizes, words); return at; }
  /** Runs with numbers that are needed no longer. */
  lend(name, Type, source, run) {
    const missing = source === undefined ? "missing" : "no array";
    if (source?.length === undefined) throw new TypeError(`${name} is ${missing}`);
    const numbers = new Numbers(this, Type, source);
    try { return run(numbers.view.byteOffset, numbers.length); } finally { numbers.free(); }
  }
  /** Place and count of an array of things of `size` numbers. */
  array(name, numbers, size = 1) { return Numbers.place(this, name, numbers, size); }
  /** The same of one that may be missing. */
  maybe(name, numbers, size = 1) { return (numbers ?? null) === null ? [0, 0] : this.array(name, numbers, size); }
  /**
   * Calls a function of numbers, arrays that are read and arrays that are written: { name: [array, size, whether it may
   * be missing] }. What is written can be none of those, nor of further `inputs`.
   */
  call(name, plain, reads = {}, writes = {}, inputs = {}, words = {}) {
    const all = Object.entries({ ...reads, ...writes });
    for (const input in reads) inputs[input] = reads[input][0];
    for (const written in writes) this.apart(written, writes[written][0], inputs);
    const place = ([name, [numbers, size, missing]]) => this[missing ? "maybe" : "array"](name, numbers, size);
    const places = all.map(place);
    if (this.raw[name](...plain, ...places.flat()) !== 0) {
      throw this.error({ ...words.sizes, ...Object.fromEntries(all.map(([name, [, size]]) => [name, size])) }, words);
    }
  }
  /** What is written can be none of what is read. */
  apart(name, numbers, inputs) {
    for (const input in inputs) {
      const other = inputs[input];
      if (numbers && other === numbers) throw new RangeError(`${name} is the same array as ${input}`);
      const both = numbers instanceof Numbers && other instanceof Numbers;
      if (both && Numbers.overlap(numbers, other)) throw new RangeError(`${name} has numbers of ${input}`);
    }
  }
}

/** A number that Rust counts by. */
export function count(name, value) {
  if (value === undefined) throw new TypeError(`${name} is missing`);
  const whole = Number.isInteger(value) && value >= 0 && value < 2 ** 31;
  if (!whole) throw new RangeError(`${name} is ${value}, not a whole number`);
  return value;
}

/** What lives in the module until it is freed. */
export class Noun {
  #at; #name; #free;
  constructor(module, at, free) {
    this.#at = at;
    this.#name = free.slice("dq8_".length, -"_free".length);
    this.#free = () => module.raw[free](this.#at);
  }
  get place() {
    if (this.#at === 0) throw new Error(`the ${this.#name} has been freed`);
    return this.#at;
  }
  free() { if (this.#at) this.#free(); this.#at = 0; }
}
