// Binary glTF files, written by the tests: accessors, then the JSON that names them.

const TYPES = {
  Int8Array: 5120,
  Uint8Array: 5121,
  Int16Array: 5122,
  Uint16Array: 5123,
  Uint32Array: 5125,
  Float32Array: 5126,
};
const WIDTHS = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 };

export class File {
  #parts = [];
  #size = 0;
  json = { asset: { version: "2.0" }, bufferViews: [], accessors: [] };
  /** The number of a new view with these numbers. */
  view(array) {
    const bytes = new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
    this.json.bufferViews.push({ buffer: 0, byteOffset: this.#size, byteLength: bytes.length });
    this.#parts.push([this.#size, bytes]);
    this.#size += (bytes.length + 3) & ~3;
    return this.json.bufferViews.length - 1;
  }
  /** The number of a new accessor; a plain array has floats. */
  accessor(type, numbers, extra = {}) {
    const array = Array.isArray(numbers) ? Float32Array.from(numbers) : numbers;
    const accessor = {
      bufferView: this.view(array),
      componentType: TYPES[array.constructor.name],
      type,
      count: array.length / WIDTHS[type],
      ...extra,
    };
    if (type === "SCALAR" && array.length)
      Object.assign(accessor, { min: [Math.min(...array)], max: [Math.max(...array)] });
    return this.json.accessors.push(accessor) - 1;
  }
  /** The number of a new accessor of zeros, but for some of its elements. */
  sparse(type, count, indices, numbers) {
    const [at, values] = [this.view(Uint16Array.from(indices)), this.view(Float32Array.from(numbers))];
    const sparse = {
      count: indices.length,
      indices: { bufferView: at, componentType: 5123 },
      values: { bufferView: values },
    };
    return this.json.accessors.push({ componentType: 5126, type, count, sparse }) - 1;
  }
  binary() {
    const binary = new Uint8Array(this.#size);
    for (const [at, bytes] of this.#parts) binary.set(bytes, at);
    return binary;
  }
  /** The bytes of a .glb. */
  bytes(json = {}) {
    const whole = { ...this.json, buffers: [{ byteLength: this.#size }], ...json };
    let text = new TextEncoder().encode(JSON.stringify(whole));
    text = Uint8Array.from({ length: (text.length + 3) & ~3 }, (_, i) => text[i] ?? 32);
    const bytes = new Uint8Array(12 + 8 + text.length + 8 + this.#size),
      data = new DataView(bytes.buffer);
    [0x46546c67, 2, bytes.length, text.length, 0x4e4f534a].forEach((word, i) => data.setUint32(4 * i, word, true));
    bytes.set(text, 20);
    data.setUint32(20 + text.length, this.#size, true);
    data.setUint32(24 + text.length, 0x004e4942, true);
    bytes.set(this.binary(), 28 + text.length);
    return bytes.buffer;
  }
}
