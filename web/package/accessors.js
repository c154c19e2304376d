// The numbers of a glTF: buffers, views and accessors, sparse ones too. Errors name the place in
// the file.

const ARRAYS = {
  5120: Int8Array,
  5121: Uint8Array,
  5122: Int16Array,
  5123: Uint16Array,
  5125: Uint32Array,
  5126: Float32Array,
};
const WIDTHS = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 };
const COMPRESSED = ["EXT_meshopt_compression", "KHR_meshopt_compression"];

export const fail = (place, text) => {
  throw new Error(`${place}: ${text}`);
};
/** Bytes of what may be a buffer or an array over one. */
export const bytesOf = (data) =>
  ArrayBuffer.isView(data) ? new Uint8Array(data.buffer, data.byteOffset, data.byteLength) : new Uint8Array(data);

const JSON_CHUNK = 0x4e4f534a,
  BINARY_CHUNK = 0x004e4942;

/** JSON and buffers of a binary glTF. */
export function readGlb(file) {
  const bytes = bytesOf(file),
    data = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength),
    chunks = new Map();
  if (bytes.length < 20 || data.getUint32(0, true) !== 0x46546c67) fail("byte 0", "this is no .glb");
  if (data.getUint32(4, true) !== 2) fail("byte 4", "this is no glTF 2");
  for (let at = 12; at + 8 <= bytes.length;) {
    const length = data.getUint32(at, true),
      type = data.getUint32(at + 4, true);
    if (at + 8 + length > bytes.length) fail(`byte ${at}`, "a chunk ends beyond the file");
    if (!chunks.has(type)) chunks.set(type, bytes.subarray(at + 8, at + 8 + length));
    at += 8 + length;
  }
  if (!chunks.has(JSON_CHUNK)) fail("byte 12", "there is no JSON chunk");
  try {
    return { json: JSON.parse(new TextDecoder().decode(chunks.get(JSON_CHUNK))), buffers: [chunks.get(BINARY_CHUNK)] };
  } catch (error) {
    return fail("byte 20", error.message);
  }
}

/** Reads accessors; each is an array of doubles. */
export class Accessors {
  #json;
  #buffers;
  constructor({ json, buffers = [] }) {
    this.#json = json;
    this.#buffers = [...buffers];
  }
  /** Whether the file cannot be read without an extension. */
  required(name) {
    return this.#json.extensionsRequired?.includes(name) ?? false;
  }
  #buffer(index, place) {
    const given = this.#buffers[index],
      { uri } = this.#json.buffers?.[index] ?? fail(place, `there is no buffer ${index}`);
    if (given) return bytesOf(given);
    const data =
      /^data:[^,]*;base64,(.*)$/s.exec(uri ?? "")?.[1] ??
      fail(`buffers[${index}]`, `${uri ?? "its bytes"} must be given: { json, buffers }`);
    return (this.#buffers[index] = Uint8Array.from(atob(data), (c) => c.charCodeAt(0)));
  }
  /** Numbers [count][width] in a view. */
  #numbers(index, offset, Type, width, count, most, place) {
    const view = this.#json.bufferViews?.[index] ?? fail(place, `there is no bufferView ${index}`);
    for (const name of COMPRESSED)
      if (view.extensions?.[name]) fail(place, `bufferViews[${index}] is compressed by ${name}: decode the file first`);
    const bytes = this.#buffer(view.buffer, place),
      size = Type.BYTES_PER_ELEMENT,
      stride = view.byteStride ?? width * size;
    const start = (view.byteOffset ?? 0) + offset,
      end = count ? start + stride * (count - 1) + width * size : start;
    const limit = Math.min(bytes.length, (view.byteOffset ?? 0) + view.byteLength);
    if (!(start >= 0 && stride >= 0 && end <= limit)) fail(place, "its numbers lie beyond the file");
    const out = new Float64Array(width * count);
    // A copy begins where any type may begin.
    const row = (at, length) => new Type(bytes.slice(at, at + length * size).buffer);
    if (stride === width * size) out.set(row(start, out.length));
    else for (let i = 0; i < count; i++) out.set(row(start + stride * i, width), width * i);
    return most === 1 ? out : out.map((x) => x / most);
  }
  /** Numbers of an accessor of a type; `whose` has its index. */
  read(index, types, whose) {
    const place = `accessors[${index}]`,
      accessor = this.#json.accessors?.[index] ?? fail(whose, `there is no accessor ${index}`);
    const { componentType, type, count, normalized, sparse, bufferView, byteOffset = 0 } = accessor;
    const Type = ARRAYS[componentType] ?? fail(place, `componentType is ${componentType}`),
      width = WIDTHS[type];
    if (!types.includes(type)) fail(place, `type is ${type}, and ${whose} has ${types.join(" or ")}`);
    if (!(Number.isInteger(count) && count >= 0 && count < 2 ** 28)) fail(place, `count is ${count}`);
    const most =
      normalized && Type !== Float32Array ? 2 ** (8 * Type.BYTES_PER_ELEMENT - (Type.name[0] === "U" ? 0 : 1)) - 1 : 1;
    // Without a view all numbers are zero.
    const out =
      bufferView === undefined
        ? new Float64Array(width * count)
        : this.#numbers(bufferView, byteOffset, Type, width, count, most, place);
    if (sparse) {
      const Index =
        ARRAYS[sparse.indices.componentType] ??
        fail(`${place}.sparse.indices`, `componentType is ${sparse.indices.componentType}`);
      const where = this.#numbers(
        sparse.indices.bufferView,
        sparse.indices.byteOffset ?? 0,
        Index,
        1,
        sparse.count,
        1,
        `${place}.sparse.indices`,
      );
      const values = this.#numbers(
        sparse.values.bufferView,
        sparse.values.byteOffset ?? 0,
        Type,
        width,
        sparse.count,
        most,
        `${place}.sparse.values`,
      );
      where.forEach((at, i) => {
        if (!(at < count)) fail(`${place}.sparse.indices`, `${at} is beyond ${count} elements`);
        out.set(values.subarray(width * i, width * i + width), width * at);
      });
    }
    // The smallest of the signed integers is −1 as well.
    return most > 1 && Type.name[0] === "I" ? out.map((x) => Math.max(x, -1)) : out;
  }
}
