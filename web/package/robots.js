// Robots of URDF files: poses of links, Jacobians, inverse kinematics. The only file that knows what a robot exports.
import { compile as compileFile, LevelError, supports } from "./engine.js";
import { Module, Noun, Numbers, count, dispose } from "./memory.js";

const SIMD128 = { module: "dq8/robots", name: "simd128", url: () => new URL("./robots.simd128.wasm", import.meta.url) };

export const compile = (options, read) => compileFile(SIMD128, options, read);
export async function load(options, read) {
  return new Robots((await WebAssembly.instantiate(await compile(options, read), {})).exports);
}
export { load as default, LevelError, supports };

export const OUTCOMES = ["converged", "outOfReach", "atLimits", "stalled", "unfinished", "invalid"];

/** The text of a file, in the encoding that it declares. */
function decode(bytes) {
  const start = new TextDecoder("latin1").decode(new Uint8Array(bytes.buffer ?? bytes, bytes.byteOffset ?? 0, Math.min(200, bytes.byteLength)));
  return new TextDecoder(/^<\?xml[^>]*encoding=["']([\w-]+)/.exec(start)?.[1] ?? "utf-8").decode(bytes);
}

export class Robots {
  #module;
  constructor(raw) { this.#module = new Module(raw); }
  floats(source) { return new Numbers(this.#module, Float32Array, source); }
  /** A robot of the text or the bytes of a URDF file. */
  robot(urdf) { return new Robot(this.#module, urdf); }
}

export class Robot {
  #module; #noun; #report;
  constructor(module, urdf) {
    const { raw } = module, bytes = new TextEncoder().encode(typeof urdf === "string" ? urdf : decode(urdf));
    this.#module = module;
    this.#noun = new Noun(module, module.lend(Uint8Array, bytes, (at, n) => raw.dq8_robot(at, n)), "dq8_robot_free");
    const at = this.#noun.place, words = (line) => line === "" ? [] : line.split("\t");
    const [links, values, parents, warnings] = module.string(raw.dq8_robot_text(at), raw.dq8_robot_text_length(at)).split("\n").map(words);
    this.linkNames = links;
    this.valueNames = values;
    this.parents = parents.map(Number);
    this.warnings = warnings;
    this.rates = raw.dq8_robot_rates(at);
    /** [lower, upper] of each value, infinite where there is none. */
    this.valueLimits = values.map((_, i) => [...new Float32Array(raw.memory.buffer, raw.dq8_robot_limits(at) + 8 * i, 2)]);
    this.#report = new Numbers(module, Float32Array, 4);
  }
  link(name) { const link = this.linkNames.indexOf(name); return link < 0 ? undefined : link; }
  /** [configuration][value] to [configuration][link]. */
  poses(values, poses) { this.#module.call("dq8_robot_poses", [this.#noun.place], { values: [values, 1] }, { poses: [poses, 8] }); }
  /** [configuration][rate] of six numbers, angular first, in the axes of the world. */
  jacobians(link, values, columns) {
    this.#module.call("dq8_robot_jacobians", [this.#noun.place, count("link", link)], { values: [values, 1] }, { columns: [columns, 6] });
  }
  /** Moves `values` until `link` is at `target`, a motion; only its position with `position`. */
  reach(link, target, values, { position = false, restarts = true } = {}) {
    const m = this.#module, to = m.output("values", values, 1, { target });
    const outcome = m.raw.dq8_robot_reach(this.#noun.place, count("link", link), +position, +restarts, this.#report.view.byteOffset, ...m.array("target", target, 8), ...to);
    if (outcome === 255) throw m.error();
    const [iterations, again, angularError, linearError] = this.#report.view;
    return { outcome: OUTCOMES[outcome], iterations, restarts: again, angularError, linearError };
  }
  free() { this.#noun.free(); this.#report.free(); }
  [dispose]() { this.free(); }
}
