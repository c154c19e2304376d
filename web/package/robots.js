// Robots of URDF files: poses of links, Jacobians, inverse kinematics. The only file that knows what a robot exports.
import { floats, motions } from "./arrays.js";
import { compile as compileFile, LevelError, supports } from "./engine.js";
import { Module, Noun, Numbers, count, dispose } from "./memory.js";

const SIMD128 = { module: "dq8/robots", name: "simd128", url: () => new URL("./robots.simd128.wasm", import.meta.url) };

export const compile = (options, read) => compileFile(SIMD128, options, read);
export async function load(options, read) {
  const code = await compile(options, read);
  return new Robots((await WebAssembly.instantiate(code, {})).exports);
}
export { load as default, LevelError, supports };

export const OUTCOMES = ["converged", "outOfReach", "atLimits", "stalled", "unfinished", "invalid"];

/** The text of a file, in the encoding that it declares. */
function decode(bytes) {
  const first = new Uint8Array(bytes.buffer ?? bytes, bytes.byteOffset ?? 0, Math.min(200, bytes.byteLength));
  const start = new TextDecoder("latin1").decode(first);
  return new TextDecoder(/^<\?xml[^>]*encoding=["']([\w-]+)/.exec(start)?.[1] ?? "utf-8").decode(bytes);
}

const refuse = (text) => {
  throw new RangeError(text);
};

export class Robots {
  #module;
  constructor(raw) {
    this.#module = new Module(raw, "robots");
  }
  floats(source) {
    return floats(this.#module, source);
  }
  /** Motions, eight numbers each: so many identities, or those of an array. */
  motions(source) {
    return motions(this.#module, source);
  }
  /** A robot of the text or the bytes of a URDF file. */
  robot(urdf) {
    return new Robot(this.#module, urdf);
  }
}

/** What instances of a robot are made of, and the names that Rust has for many goals. */
const VALUES = { each: "value" },
  REACH = { names: { targets: "target" } };

export class Robot {
  #module;
  #noun;
  #report;
  constructor(module, urdf) {
    if (typeof urdf !== "string" && !(urdf instanceof ArrayBuffer || ArrayBuffer.isView(urdf))) {
      throw new TypeError(`urdf is ${urdf === undefined ? "missing" : "neither text nor bytes"}`);
    }
    const { raw } = module,
      bytes = new TextEncoder().encode(typeof urdf === "string" ? urdf : decode(urdf));
    this.#module = module;
    const made = module.lend("urdf", Uint8Array, bytes, (at, n) => module.made(raw.dq8_robot(at, n)));
    this.#noun = new Noun(module, made, "dq8_robot_free");
    const at = this.#noun.place,
      words = (line) => (line === "" ? [] : line.split("\t"));
    const text = module.string(raw.dq8_robot_text(at), raw.dq8_robot_text_length(at));
    const [links, values, parents, warnings] = text.split("\n").map(words);
    this.linkNames = links;
    this.valueNames = values;
    this.parents = parents.map(Number);
    this.warnings = warnings;
    this.rates = raw.dq8_robot_rates(at);
    /** [lower, upper] of each value, infinite where there is none. */
    const limits = (i) => new Float32Array(raw.memory.buffer, (raw.dq8_robot_limits(at) >>> 0) + 8 * i, 2);
    this.valueLimits = values.map((_, i) => [...limits(i)]);
    this.#report = new Numbers(module, Float32Array, 4);
  }
  link(name) {
    const link = this.linkNames.indexOf(name);
    return link < 0 ? undefined : link;
  }
  /** The number of a link, which may be given by its name. */
  #link(link) {
    if (typeof link !== "string") return count("link", link);
    return this.link(link) ?? refuse(`link is ${link}, none of ${this.linkNames.join(", ")}`);
  }
  /** [configuration][value] to [configuration][link]. */
  poses(values, poses) {
    const plain = [this.#noun.place];
    this.#module.call("dq8_robot_poses", plain, { values: [values, 1] }, { poses: [poses, 8] }, {}, VALUES);
  }
  /** [configuration][rate] of six numbers, angular first, in the axes of the world. */
  jacobians(link, values, columns) {
    const plain = [this.#noun.place, this.#link(link)];
    this.#module.call("dq8_robot_jacobians", plain, { values: [values, 1] }, { columns: [columns, 6] }, {}, VALUES);
  }
  /** Moves `values` until `link` is at `target`, a motion; only its position with `position`. */
  reach(link, target, values, { position = false, restarts = true } = {}) {
    const m = this.#module,
      options = [this.#link(link), +position, +restarts, this.#report.view.byteOffset];
    const places = [...m.array("target", target, 8), ...m.array("values", values)];
    m.apart("values", values, { target });
    const outcome = m.raw.dq8_robot_reach(this.#noun.place, ...options, ...places);
    if (outcome === 255) throw m.error({ target: 8, values: 1 }, REACH);
    const [iterations, again, angularError, linearError] = this.#report.view;
    return { outcome: OUTCOMES[outcome], iterations, restarts: again, angularError, linearError };
  }
  free() {
    this.#noun.free();
    this.#report.free();
  }
  [dispose]() {
    this.free();
  }
}
