// Robots of URDF files: poses of links, Jacobians, inverse kinematics. The only file that knows what a robot exports.
import { floats, motions } from "./arrays.js";
import { Module, Noun, Numbers, count, instantiate, dispose } from "./memory.js";

const FILES = {
  simd128: () => new URL("./robots.simd128.wasm", import.meta.url),
  relaxed: () => new URL("./robots.relaxed.wasm", import.meta.url),
};

export default async function load(options) { return new Robots(await instantiate(FILES, options)); }

export const OUTCOMES = ["converged", "outOfReach", "atLimits", "stalled", "unfinished", "invalid"];

/** The text of a file, in the encoding that it declares. */
function decode(bytes) {
  const start = new TextDecoder("latin1").decode(new Uint8Array(bytes.buffer ?? bytes, bytes.byteOffset ?? 0, Math.min(200, bytes.byteLength)));
  return new TextDecoder(/^<\?xml[^>]*encoding=["']([\w-]+)/.exec(start)?.[1] ?? "utf-8").decode(bytes);
}

const refuse = (text) => { throw new RangeError(text); };

export class Robots {
  #module;
  constructor(raw) { this.#module = new Module(raw); }
  floats(source) { return floats(this.#module, source); }
  /** Motions, eight numbers each: so many identities, or those of an array. */
  motions(source) { return motions(this.#module, source); }
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
  /** The number of a link, which may be given by its name. */
  #link(link) {
    if (typeof link !== "string") return count("link", link);
    return this.link(link) ?? refuse(`link is ${link}, none of ${this.linkNames.join(", ")}`);
  }
  /** [configuration][value] to [configuration][link]. */
  poses(values, poses) { this.#module.call("dq8_robot_poses", [this.#noun.place], { values: [values, 1] }, { poses: [poses, 8] }); }
  /** [configuration][rate] of six numbers, angular first, in the axes of the world. */
  jacobians(link, values, columns) {
    this.#module.call("dq8_robot_jacobians", [this.#noun.place, this.#link(link)], { values: [values, 1] }, { columns: [columns, 6] });
  }
  /** Moves `values` until `link` is at `target`, a motion; only its position with `position`. */
  reach(link, target, values, { position = false, restarts = true } = {}) {
    const m = this.#module, to = m.output("values", values, 1, { target });
    const outcome = m.raw.dq8_robot_reach(this.#noun.place, this.#link(link), +position, +restarts, this.#report.view.byteOffset, ...m.array("target", target, 8), ...to);
    if (outcome === 255) throw m.error();
    const [iterations, again, angularError, linearError] = this.#report.view;
    return { outcome: OUTCOMES[outcome], iterations, restarts: again, angularError, linearError };
  }
  free() { this.#noun.free(); this.#report.free(); }
  [dispose]() { this.free(); }
}
