// How a module comes into an engine: which levels the engine has, where the file lies, and why it does not start.

/** Smallest modules with an instruction of each level, to ask engines about: `i8x16.splat` and `f32x4.relaxed_madd`. */
const HEAD = [0, 97, 115, 109, 1, 0, 0, 0, 1, 4, 1, 96, 0, 0, 3, 2, 1, 0, 10],
  VECTOR = [65, 0, 253, 15];
const PROBES = {
  simd128: [...HEAD, 9, 1, 7, 0, ...VECTOR, 26, 11],
  relaxed: [...HEAD, 20, 1, 18, 0, ...VECTOR, ...VECTOR, ...VECTOR, 253, 133, 2, 26, 11],
};
const NEEDS = {
  simd128: "SIMD in WebAssembly, which Chrome has since 91, Firefox since 89, Safari since 16.4 and node since 16",
  relaxed: "relaxed SIMD in WebAssembly, which Chrome has since 114, Firefox since 145 and node since 22",
};

/** Whether this engine has the instructions of a level, "simd128" or "relaxed". */
export function supports(level) {
  if (!Object.hasOwn(PROBES, level))
    throw new RangeError(`level is ${level}, none of ${Object.keys(PROBES).join(", ")}`);
  return typeof WebAssembly === "object" && WebAssembly.validate(Uint8Array.from(PROBES[level]));
}

/** The engine lacks the instructions of a level. */
export class LevelError extends Error {
  constructor(level) {
    super(typeof WebAssembly === "object" ? `this engine has no ${NEEDS[level]}` : "this engine has no WebAssembly");
    this.name = "LevelError";
    this.level = level;
  }
}

const PASS = "pass its bytes as load({ wasm })";
const COPY = "esbuild and Rollup copy no such files: copy it beside the bundle from node_modules/dq8, or " + PASS;

/** The bytes of a file, as browsers get them. */
export async function fetched(url) {
  if (url.protocol === "file:") {
    throw new Error(
      `${url} cannot be fetched: pages that are opened as files may read none. Serve the page, or ${PASS}`,
    );
  }
  const answer = await fetch(url).catch((cause) => {
    throw new Error(`${url} cannot be fetched: ${cause.message}`, { cause });
  });
  if (!answer.ok) throw new Error(`${url}: ${answer.status} ${answer.statusText}. ${COPY}`);
  return answer.arrayBuffer();
}

/** The bytes of a file on a disk, by the function that reads it. */
export const readBy = (readFile) => (url) =>
  url.protocol !== "file:"
    ? fetched(url)
    : readFile(url).catch((cause) => {
        throw new Error(`${url} cannot be read: ${cause.message}. ${COPY}`, { cause });
      });

/** The level that is asked for, or the one that stands in for it. */
function chosen(simd128, level, fallback) {
  if (level === "simd128") return chosen(simd128, simd128, fallback);
  if (level?.module !== simd128.module) {
    const path = simd128.module === "dq8" ? "dq8/relaxed" : `${simd128.module}-relaxed`;
    const is = typeof level === "string" ? level : `${level?.name} of ${level?.module}`;
    throw new RangeError(`level is ${is}, neither "simd128" nor what ${path} exports`);
  }
  if (supports(level.name)) return level;
  if (fallback && level !== simd128) return chosen(simd128, simd128, fallback);
  throw new LevelError(level.name);
}

/** Why bytes did not compile. */
function explained(cause, bytes, name) {
  if (!supports("simd128")) return new LevelError("simd128");
  const start = new Uint8Array(bytes.buffer ?? bytes, bytes.byteOffset ?? 0, Math.min(4, bytes.byteLength));
  let why = cause.message;
  if (String.fromCharCode(...start) !== "\0asm")
    why = "this is no WebAssembly; servers answer so with a page for a file that they lack";
  else if (WebAssembly.validate(bytes))
    why = "the page's content security policy forbids WebAssembly: script-src needs 'wasm-unsafe-eval'";
  else if (!supports("relaxed")) why += `; if the file is of the level relaxed: ${new LevelError("relaxed").message}`;
  return new Error(`${name}: ${why}`, { cause });
}

/** A compiled module: of the file of its level, or of what the caller has. */
export async function compile(simd128, { level = simd128, fallback = false, wasm } = {}, read = fetched) {
  if (typeof WebAssembly !== "object") throw new LevelError("simd128");
  if (wasm instanceof WebAssembly.Module) return wasm;
  if (wasm !== undefined && !(wasm instanceof ArrayBuffer || ArrayBuffer.isView(wasm))) {
    throw new TypeError("wasm is neither an ArrayBuffer, nor a view of one, nor a WebAssembly.Module");
  }
  let bytes = wasm,
    name = "wasm";
  if (wasm === undefined) {
    const file = chosen(simd128, level, fallback);
    try {
      name = file.url();
    } catch (cause) {
      throw new Error(`this bundle has no import.meta.url to find a file by: make it an ES module, or ${PASS}`, {
        cause,
      });
    }
    bytes = await read(name);
  }
  return WebAssembly.compile(bytes).catch((cause) => {
    throw explained(cause, bytes, name);
  });
}
