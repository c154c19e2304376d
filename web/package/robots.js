// Robots of URDF files: poses of links, Jacobians, inverse kinematics. The only file that knows what a robot exports.
import { floats, motions } from "./arrays.js";
import { compile as compileFile, LevelError, supports } from "./engine.js";
import { guesses } from "./loud.js";
import { Module, Noun, Numbers, count, dispose } from "./memory.js";

const SIMD128 = { module: "dq8/robots", name: "simd128", url: () => new URL("./robots.simd128.wasm", import.meta.url) };

export const compile = (options, read) => compileFile(SIMD128, options, read);
export async function load(options, read) {
  const code = await compile(options, read);
  return new Robots((await WebAssembly.instantiate(code, {})).exports);
}
export { load as default, LevelError, Numbers as Floats, supports };

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
  /** A robot of the text or the bytes of a URDF file, on a base, and with tools. */
  robot(urdf, options) {
    return new Robot(this.#module, urdf, options);
  }
}

/** What instances of a robot are made of, and the names that Rust has for many goals. */
const VALUES = { each: "value" },
  REACH = { names: { targets: "target" } };
const FAMILIES = ["sphericalWrist", "threeParallel", "other"];

/** The place of one motion. */
function one(module, name, numbers) {
  const [at, found] = module.array(name, numbers, 8);
  if (found !== 1) refuse(`${name} holds ${found} motions where 1 is needed`);
  return at;
}

/** The place of a robot of a file, with what it stands on and what it holds. */
function make(module, urdf, { floating = false, base, tools = [] } = {}) {
  if (typeof urdf !== "string" && !(urdf instanceof ArrayBuffer || ArrayBuffer.isView(urdf))) {
    throw new TypeError(`urdf is ${urdf === undefined ? "missing" : "neither text nor bytes"}`);
  }
  if (floating && base) refuse("a base that is floating stands at no base");
  const { raw } = module,
    encoder = new TextEncoder(),
    bytes = encoder.encode(typeof urdf === "string" ? urdf : decode(urdf));
  const lend = (name, text, run) => module.lend(name, Uint8Array, encoder.encode(text), run);
  const check = (status) => {
    if (status !== 0) throw module.error();
  };
  const draft = module.lend("urdf", Uint8Array, bytes, (at, n) => module.made(raw.dq8_urdf(at, n)));
  try {
    if (floating) check(raw.dq8_urdf_floating(draft));
    if (base) check(raw.dq8_urdf_base(draft, one(module, "base", base)));
    for (const [i, { name, link, pose }] of tools.entries()) {
      for (const [of, text] of Object.entries({ name, link }))
        if (typeof text !== "string") throw new TypeError(`tools[${i}].${of} is no name`);
      const at = one(module, `tools[${i}].pose`, pose);
      lend("name", name, (...names) =>
        lend("link", link, (...links) => check(raw.dq8_urdf_tool(draft, at, ...names, ...links))),
      );
    }
    return module.made(raw.dq8_robot(draft));
  } finally {
    raw.dq8_urdf_free(draft);
  }
}

export class Robot {
  #module;
  #noun;
  constructor(module, urdf, options) {
    const { raw } = module;
    this.#module = module;
    this.#noun = new Noun(module, make(module, urdf, options), "dq8_robot_free");
    const at = this.#noun.place;
    const [links, values, ...names] = module.string(raw.dq8_robot_text(at), raw.dq8_robot_text_length(at)).split("\0");
    this.linkNames = names.splice(0, links);
    this.valueNames = names.splice(0, values);
    this.parents = names.splice(0, links).map(Number);
    this.warnings = names;
    this.rates = raw.dq8_robot_rates(at);
    /** [lower, upper] of each value, infinite where there is none. */
    const limits = (i) => new Float32Array(raw.memory.buffer, (raw.dq8_robot_limits(at) >>> 0) + 8 * i, 2);
    this.valueLimits = this.valueNames.map((_, i) => [...limits(i)]);
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
  #reach(link, { position = false, restarts = true } = {}, count, name, targets, values, words) {
    const { raw } = this.#module,
      at = this.#noun.place,
      plain = [at, this.#link(link), +position, +restarts, count];
    this.#module.call("dq8_robot_reach", plain, { [name]: [targets, 8] }, { values: [values, 1] }, {}, words);
    const place = raw.dq8_robot_reports(at) >>> 0,
      [words32, floats32] = [Uint32Array, Float32Array].map((Type) => new Type(raw.memory.buffer, place, 5 * count));
    return Array.from({ length: count }, (_, i) => {
      const [outcome, iterations, again] = words32.subarray(5 * i),
        [angularError, linearError] = floats32.subarray(5 * i + 3);
      return { outcome: OUTCOMES[outcome], iterations, restarts: again, angularError, linearError };
    });
  }
  /** Moves `values` until `link` is at `target`, a motion; only its position with `position`. */
  reach(link, target, values, options) {
    return this.#reach(link, options, 1, "target", target, values, REACH)[0];
  }
  /** The same for the target and the values of each configuration, four at a time. */
  reachEach(link, targets, values, options) {
    const [, count] = this.#module.array("targets", targets, 8);
    return this.#reach(link, options, count, "targets", targets, values);
  }
  /** Goes on from `values` to the next target of each configuration, and never begins elsewhere. */
  follow(link, targets, values, options) {
    return this.reachEach(link, targets, values, { ...options, restarts: false });
  }
  /** All values that bring a link of an arm of six hinges to `target`, those nearest to `values` first. */
  solutions(link, target, values) {
    const { raw } = this.#module,
      at = this.#noun.place,
      reads = { target: [target, 8], values: [values, 1] };
    this.#module.call("dq8_robot_solve", [at, this.#link(link)], reads);
    const place = raw.dq8_robot_solutions(at) >>> 0,
      numbers = new Float32Array(raw.memory.buffer, place, raw.dq8_robot_solutions_length(at));
    const n = values.length,
      found = [];
    for (let i = 2; i < numbers.length; i += n + 4) {
      const [shoulder, elbow, wrist] = Array.from(numbers.subarray(i + n + 1, i + n + 4), Boolean);
      found.push({
        values: numbers.slice(i, i + n),
        distance: numbers[i + n],
        singular: { shoulder, elbow, wrist },
      });
    }
    return { family: FAMILIES[numbers[0]], isComplete: numbers[1] === 1, found };
  }
  free() {
    this.#noun.free();
  }
  [dispose]() {
    this.free();
  }
}

guesses(Robot, { solve: "reach", ik: "reach", forwardKinematics: "poses", jointNames: "valueNames" });
