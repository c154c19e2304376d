// Arrays in the memory of a module, and what all nouns share: arguments become places, numbers become errors.

const text = new TextDecoder();
/** So that `using` frees what has it; older engines have `free` alone. */
export const dispose = Symbol.dispose ?? Symbol("dispose");

/** Rust's names of arguments, as they are called here. */
const asWritten = (message) => message.replace(/\b[a-z]+(?:_[a-z]+)+\b/g, (name) => name.replace(/_(.)/g, (_, c) => c.toUpperCase()));

/** Numbers in a module's memory. */
export class Numbers {
  #module; #Type; #view; #at; #length;
  constructor(module, Type, source) {
    const length = typeof source === "number" ? source : source.length;
    if (!(Number.isInteger(length) && length >= 0)) throw new RangeError(`length is ${length}, not a whole number`);
    this.#module = module; this.#Type = Type; this.#length = length;
    this.#at = length * Type.BYTES_PER_ELEMENT < 2 ** 31 ? module.raw.dq8_allocate(length * Type.BYTES_PER_ELEMENT) >>> 0 : 0;
    if (this.#at === 0) throw new RangeError(`there is no memory for ${length} numbers`);
    if (typeof source !== "number") this.view.set(source);
  }
  get length() { return this.#length; }
  /** The numbers, without a copy. Take it again after anything that allocates, which may move all memory. */
  get view() {
    if (this.#at === 0) throw new Error("it has been freed");
    const { buffer } = this.#module.raw.memory;
    if (this.#view?.buffer !== buffer) this.#view = new this.#Type(buffer, this.#at, this.#length);
    return this.#view;
  }
  free() {
    if (this.#at) this.#module.raw.dq8_free(this.#at, this.#length * this.#Type.BYTES_PER_ELEMENT);
    this.#at = this.#length = 0;
    this.#view = undefined;
  }
  [dispose]() { this.free(); }
  /** Place and count of an array of things of `size` numbers. */
  static place(module, name, numbers, size) {
    if (!(numbers instanceof Numbers) || numbers.#Type !== Float32Array) throw new TypeError(`${name} is no array of dq8.floats`);
    if (numbers.#module !== module) throw new TypeError(`${name} is an array of another module`);
    if (numbers.#at === 0) throw new Error(`${name} has been freed`);
    if (numbers.#length % size) throw new RangeError(`${name} holds ${numbers.#length} numbers, which is not a multiple of ${size}`);
    return [numbers.#at, numbers.#length / size];
  }
}

/** An instance of a module. */
export class Module {
  raw;
  constructor(raw) { this.raw = raw; }
  string(at, length) { return text.decode(new Uint8Array(this.raw.memory.buffer, at, length)); }
  error() { return new Error(asWritten(this.string(this.raw.dq8_error(), this.raw.dq8_error_length()))); }
  check(status) { if (status !== 0) throw this.error(); }
  /** The place of what has been made. */
  made(at) { if (at === 0) throw this.error(); return at; }
  /** Runs with numbers that are needed no longer. */
  lend(Type, source, run) {
    const numbers = new Numbers(this, Type, source);
    try { return run(numbers.view.byteOffset, numbers.length); } finally { numbers.free(); }
  }
  /** Place and count of an array of things of `size` numbers. */
  array(name, numbers, size = 1) { return Numbers.place(this, name, numbers, size); }
  /** The same of one that may be missing. */
  maybe(name, numbers, size = 1) { return numbers ? this.array(name, numbers, size) : [0, 0]; }
  /** Calls a function of numbers, arrays that are read and arrays that are written: { name: [array, size, whether it may be missing] }. */
  call(name, plain, reads = {}, writes = {}, inputs = {}) {
    for (const input in reads) inputs[input] = reads[input][0];
    const write = Object.entries(writes).flatMap(([name, [numbers, size]]) => this.output(name, numbers, size, inputs));
    const read = Object.entries(reads).flatMap(([name, [numbers, size, missing]]) => missing ? this.maybe(name, numbers, size) : this.array(name, numbers, size));
    this.check(this.raw[name](...plain, ...read, ...write));
  }
  /** Of one that is written, and so can be none of those that are read. */
  output(name, numbers, size, inputs) {
    for (const [input, other] of Object.entries(inputs)) if (other === numbers) throw new RangeError(`${name} is the same array as ${input}`);
    return this.array(name, numbers, size);
  }
}

/** A number that Rust counts by. */
export function count(name, value) {
  if (!(Number.isInteger(value) && value >= 0 && value < 2 ** 31)) throw new RangeError(`${name} is ${value}, not a whole number`);
  return value;
}

/** What lives in the module until it is freed. */
export class Noun {
  #at; #free;
  constructor(module, at, free) { this.#at = module.made(at); this.#free = () => module.raw[free](this.#at); }
  get place() {
    if (this.#at === 0) throw new Error(`the ${this.constructor.name} has been freed`);
    return this.#at;
  }
  free() { if (this.#at) this.#free(); this.#at = 0; }
  [dispose]() { this.free(); }
}
