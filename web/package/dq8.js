// dq8 for JavaScript: skeletons, clips and skins, many at a time. README.md begins with an example.
import { floats, motions } from "./arrays.js";
import { compile as compileFile, LevelError, supports } from "./engine.js";
import { guesses } from "./loud.js";
import { Module, Noun, Numbers, count, dispose } from "./memory.js";
import { LOCALS, Sampled, Scratch } from "./sampled.js";

// Written out, so that bundlers find and copy the file.
const SIMD128 = { module: "dq8", name: "simd128", url: () => new URL("./dq8.simd128.wasm", import.meta.url) };

/** The compiled code, which workers can be sent. */
export const compile = (options, read) => compileFile(SIMD128, options, read);
/** A module of its own, with its own memory. */
export async function load(options, read) {
  const code = await compile(options, read);
  return new Dq8((await WebAssembly.instantiate(code, {})).exports);
}
export { load as default, LevelError, Numbers as Floats, Sampled, supports };

// Nouns keep their module and their places to themselves: what has been checked cannot be written to.
const modules = new WeakMap(),
  places = new WeakMap();
const of = (noun, Type, name) => {
  if (!(noun instanceof Type))
    throw new TypeError(noun === undefined ? `${name} is missing` : `${name} is no ${Type.name}`);
  return places.get(noun).place;
};
const keep = (noun, module, at, free) => {
  modules.set(noun, module);
  places.set(noun, new Noun(module, at, free));
};

class Handle {
  free() {
    places.get(this).free();
  }
  [dispose]() {
    this.free();
  }
}
/** Calls what a noun can do. */
const run = (noun, name, plain, ...arrays) =>
  modules.get(noun).call(name, [places.get(noun).place, ...plain], ...arrays);

const same = (name, found, needed) => {
  if (found !== needed) throw new RangeError(`${name} holds ${found} motions where ${needed} are needed`);
};

export class Dq8 {
  #module;
  constructor(raw) {
    this.#module = new Module(raw, "dq8");
  }
  /** Numbers: so many zeros, or those of an array. */
  floats(source) {
    return floats(this.#module, source);
  }
  /** Motions, eight numbers each: so many identities, or those of an array. */
  motions(source) {
    return motions(this.#module, source);
  }
  /** Locals of an array as a source of poses, to blend and to add. */
  poses(locals) {
    return new Sampled({ module: this.#module, locals });
  }
  skeleton(parents) {
    return new Skeleton(this.#module, parents);
  }
  /** Packed clips, of bytes that dq8/pack, Rust, C or Python wrote, copied. */
  packedClip(bytes) {
    return new PackedClip(this.#module, bytes);
  }
  skin(options) {
    return new Skin(this.#module, options);
  }
  /** Motions of [x y z w tx ty tz] each. */
  fromRotationsTranslations(poses, motions) {
    this.#module.call("dq8_from_rotations_translations", [], { poses: [poses, 7] }, { motions: [motions, 8] });
  }
  /** [x y z w tx ty tz] of unit motions. */
  toRotationsTranslations(motions, poses) {
    this.#module.call("dq8_to_rotations_translations", [], { motions: [motions, 8] }, { poses: [poses, 7] });
  }
  /** Inverses of unit motions. */
  inverse(motions, inverses) {
    const m = this.#module,
      [from, to] = [m.array("motions", motions, 8), m.array("inverses", inverses, 8)];
    m.apart("inverses", inverses, { motions });
    same("inverses", to[1], from[1]);
    inverses.view.set(motions.view);
    inverses.view.forEach((x, i, all) => {
      if (i % 4 !== 3) all[i] = -x;
    });
  }
  mul(a, b, product) {
    this.#module.call(
      "dq8_mul",
      [],
      { a: [a, 8], b: [b, 8] },
      { product: [product, 8] },
      {},
      { names: { products: "product" } },
    );
  }
  /** From a[i] to b[i], t[i] of it, along one screw. */
  sclerpEach(a, b, t, between) {
    this.#module.call("dq8_sclerp_each", [], { a: [a, 8], b: [b, 8], t: [t, 1] }, { between: [between, 8] });
  }
  /** All points by one motion. */
  transformPoints(motion, points, moved) {
    this.#module.call("dq8_transform_points", [], { motion: [motion, 8], points: [points, 3] }, { moved: [moved, 3] });
  }
  transformPointsEach(motions, points, moved) {
    this.#module.call(
      "dq8_transform_points_each",
      [],
      { motions: [motions, 8], points: [points, 3] },
      { moved: [moved, 3] },
    );
  }
  /** 4×4 matrices by columns: what WebGL, WebGPU and three.js read. */
  matrices(motions, matrices) {
    this.#module.call("dq8_matrices", [], { motions: [motions, 8] }, { matrices: [matrices, 16] });
  }
}

/** Names and sizes of arguments, for errors: Rust says models for both palettes and locals. */
const POSES = {
  names: { poses: "locals" },
  sizes: { locals: 8, roots: 8, layer: 7, at: 1, clips: 1, weights: 1, mask: 1 },
};
const PALETTE = { ...POSES, names: { models: "palette" } },
  MODELS = { names: { locals: "models" } };

export class Skeleton extends Handle {
  #scratch;
  #joints;
  constructor(module, parents) {
    super();
    const bad = Array.from(parents ?? []).findIndex(
      (parent) => !(Number.isInteger(parent) && Math.abs(parent) < 2 ** 31),
    );
    if (bad >= 0) throw new TypeError(`parents[${bad}] is ${parents[bad]}, not a whole number`);
    keep(
      this,
      module,
      module.lend("parents", Int32Array, parents, (at, n) => module.made(module.raw.dq8_skeleton(at, n))),
      "dq8_skeleton_free",
    );
    this.#joints = parents.length;
    this.#scratch = new Scratch(module, this.#joints, () => places.get(this).place);
  }
  get joints() {
    return this.#joints;
  }
  free() {
    super.free();
    this.#scratch.free();
  }
  /** A clip of keys [frame][joint][x y z w tx ty tz], copied; its times are frames, or seconds if it has a rate. */
  clip(keys, { rate = 1, loops = false } = {}) {
    return new Clip(modules.get(this), this.#joints, keys, rate, loops);
  }
  /** Poses in blocks of four instances. */
  crowd(instances) {
    return new Crowd(modules.get(this), this, instances);
  }
  /** Calls with a source, which may be over itself. */
  #pose(name, source, plain, reads, writes, inputs = {}, words = POSES) {
    of(this, Skeleton, "skeleton");
    const m = modules.get(this),
      call = (at) => run(this, name, [at, ...plain], reads, writes, inputs, words);
    if (source instanceof Sampled) {
      const [[output, [numbers, size]]] = Object.entries(writes);
      Object.assign(inputs, source.arrays());
      const instances = Math.floor(m.array(output, numbers, size)[1] / this.#joints);
      return this.#scratch.run(source, instances, call, words);
    }
    const locals = m.array("locals", source, 8);
    if (writes.models?.[0] !== source) inputs.locals = source;
    return call(this.#scratch.words(locals, LOCALS));
  }
  #roots(roots) {
    return modules.get(this).maybe("roots", roots, 8);
  }
  /** Model poses [instance][joint] of locals, or of sampled clips; over the locals themselves without `models`. */
  localToModel(source, models = source instanceof Sampled ? undefined : source, { roots } = {}) {
    this.#pose("dq8_skeleton_local_to_model", source, this.#roots(roots), {}, { models: [models, 8] }, { roots });
  }
  /** Locals of models. */
  modelToLocal(models, locals, { roots } = {}) {
    const plain = this.#roots(roots);
    run(this, "dq8_skeleton_model_to_local", plain, { models: [models, 8] }, { locals: [locals, 8] }, { roots }, POSES);
  }
  /** Locals of sampled clips, to change them and give them back. */
  locals(source, locals) {
    if (!(source instanceof Sampled)) throw new TypeError("source is neither a sample nor dq8.poses");
    this.#pose("dq8_skeleton_locals", source, [], {}, { locals: [locals, 8] });
  }
  /** Skinning palettes [instance][joint], 4×4 matrices by columns. */
  palette(source, { roots, inverseBinds, palette } = {}) {
    const reads = { inverseBinds: [inverseBinds, 8] },
      plain = this.#roots(roots);
    this.#pose("dq8_skeleton_palette", source, plain, reads, { palette: [palette, 16] }, { roots }, PALETTE);
  }
  /** The same of models, after something has changed them. */
  modelPalette(models, { inverseBinds, palette } = {}) {
    run(
      this,
      "dq8_skeleton_model_palette",
      [],
      { models: [models, 8], inverseBinds: [inverseBinds, 8] },
      { palette: [palette, 16] },
      {},
      MODELS,
    );
  }
  /** Takes the end of a limb [hip, knee, foot] to the target of each instance, its knee toward the pole. */
  twoBone(limb, models, targets, poles) {
    const joints = Array.from({ length: 3 }, (_, i) => count(`limb[${i}]`, limb[i]));
    run(this, "dq8_skeleton_two_bone", joints, { targets: [targets, 3], poles: [poles, 3] }, { models: [models, 8] });
  }
}

export class Clip extends Handle {
  #frames;
  constructor(module, joints, keys, rate, loops) {
    super();
    if (!(rate > 0 && rate < Infinity)) throw new RangeError(`rate is ${rate}, not a positive number`);
    if (keys?.length % 7) throw new RangeError(`keys holds ${keys.length} numbers, which is not a multiple of 7`);
    for (let i = 0; i < keys?.length; i += 7) {
      let turn = 0,
        shift = 0;
      for (let k = i; k < i + 7; k++) {
        const x = Math.fround(keys[k]);
        if (k < i + 4) turn += x ** 2;
        else shift += x;
      }
      if (turn > 0 && Number.isFinite(turn + shift)) continue;
      throw new RangeError(
        `keys[${i}] of frame ${Math.floor(i / 7 / joints)}, joint ${(i / 7) % joints} begins no pose`,
      );
    }
    this.#frames = keys?.length / 7 / joints;
    keep(
      this,
      module,
      module.lend("keys", Float32Array, keys, (at, n) =>
        module.made(module.raw.dq8_clip(joints, rate, +loops, at, n / 7), { keys: 7 }),
      ),
      "dq8_clip_free",
    );
  }
  /** From the first frame to the last. */
  get duration() {
    return modules.get(this).raw.dq8_clip_duration(of(this, Clip, "clip"), 0);
  }
  /** Its poses, instance i at the time at[i]. */
  sample(at, clips) {
    if (clips !== undefined) throw new TypeError("clips are of packed clips alone");
    return new Sampled({ module: modules.get(this), place: (name) => of(this, Clip, name), at, clips: 0 });
  }
  get frames() {
    return this.#frames;
  }
}

export class PackedClip extends Handle {
  constructor(module, bytes) {
    super();
    keep(
      this,
      module,
      module.lend("bytes", Uint8Array, bytes && new Uint8Array(bytes), (at, n) =>
        module.made(module.raw.dq8_packed_clip(at, n)),
      ),
      "dq8_clip_free",
    );
  }
  /** How many clips there are. */
  get clips() {
    return modules.get(this).raw.dq8_packed_clip_clips(of(this, PackedClip, "clip"));
  }
  /** How many frames one of them has; 0 if there is none of this number. */
  frames(clip = 0) {
    return modules.get(this).raw.dq8_packed_clip_frames(of(this, PackedClip, "clip"), count("clip", clip));
  }
  /**
   * From the first frame of one of them to its last, in seconds if it has a rate; 0 if there is none of this number.
   */
  duration(clip = 0) {
    return modules.get(this).raw.dq8_clip_duration(of(this, PackedClip, "clip"), count("clip", clip));
  }
  /** Poses, instance i at the time at[i] of clip clips[i], or all of one clip. */
  sample(at, clips = 0) {
    return new Sampled({ module: modules.get(this), place: (name) => of(this, PackedClip, name), at, clips });
  }
}

/** Rust's name for the poses of a crowd, for errors. */
const THINGS = { names: { things: "poses" } },
  CROWD = { names: { things: "palette", models: "palette" } };

export class Crowd extends Handle {
  #skeleton;
  #poses;
  constructor(module, skeleton, instances) {
    super();
    const bytes = 128 * skeleton.joints * Math.ceil(count("instances", instances) / 4);
    if (bytes >= 2 ** 31) throw new RangeError(`there is no memory for ${instances} instances`);
    keep(this, module, module.raw.dq8_crowd(of(skeleton, Skeleton, "skeleton"), instances), "dq8_crowd_free");
    this.#skeleton = skeleton;
    this.#poses = skeleton.joints * instances;
  }
  /** Takes poses [instance][joint]. */
  set(poses) {
    const [, found] = modules.get(this).array("poses", poses, 8);
    same("poses", found, this.#poses);
    run(this, "dq8_crowd_set", [], { poses: [poses, 8] }, {}, {}, THINGS);
  }
  /** In place. */
  localToModel() {
    run(this, "dq8_crowd_local_to_model", [of(this.#skeleton, Skeleton, "skeleton")]);
  }
  /** Skinning palettes [instance][joint] of models, 4×4 matrices by columns. */
  palette({ inverseBinds, palette } = {}) {
    const skeleton = of(this.#skeleton, Skeleton, "skeleton");
    run(
      this,
      "dq8_crowd_palette",
      [skeleton],
      { inverseBinds: [inverseBinds, 8] },
      { palette: [palette, 16] },
      {},
      CROWD,
    );
  }
  copyTo(poses) {
    run(this, "dq8_crowd_copy_to", [], {}, { poses: [poses, 8] }, {}, THINGS);
  }
}

/** What Rust calls the parts of surfaces, and what they hold. */
const SURFACE = {
  names: {
    palette: "motions",
    matrices: "motions",
    positions: "rest",
    "posed positions": "posed",
    "posed normals": "posedNormals",
  },
  sizes: { rest: 3, posed: 3, normals: 3, posedNormals: 3 },
};
const BLENDS = ["dual", "linear", "mixed"];

export class Skin extends Handle {
  #mesh;
  /** Joints and weights are copied: [vertex][influence]. */
  constructor(module, { jointCount, influences, joints, weights } = {}) {
    super();
    const bad = Array.from(joints ?? []).findIndex(
      (joint) => !(Number.isInteger(joint) && joint >= 0 && joint < 65536),
    );
    if (bad >= 0) throw new RangeError(`joints[${bad}] is ${joints[bad]}, no joint of 16 bits`);
    const counts = [count("jointCount", jointCount), count("influences", influences)],
      sizes = { joints: 1, weights: 1 };
    // A view of the module's memory would be empty once joints are there.
    if (weights?.buffer) weights = weights.slice();
    const at = module.lend("joints", Uint16Array, joints, (j, n) =>
      module.lend("weights", Float32Array, weights, (w, m) =>
        module.made(module.raw.dq8_skin(...counts, j, n, w, m), sizes, { each: "influence" }),
      ),
    );
    keep(this, module, at, "dq8_skin_free");
    this.#mesh = new Numbers(module, Uint32Array, 8);
  }
  free() {
    super.free();
    this.#mesh.free();
  }
  /** Poses a mesh by the motions of its joints: "dual", "linear", or "mixed" by a share of dual for each vertex. */
  pose({ blend = "dual", motions, shares, rest, posed, normals, posedNormals } = {}) {
    of(this, Skin, "skin");
    const m = modules.get(this),
      kind = BLENDS.indexOf(blend),
      mesh = this.#mesh.view;
    if (kind < 0) throw new RangeError(`blend is ${blend}, none of ${BLENDS.join(", ")}`);
    const reads = { motions: [motions, 8], shares: [kind === 2 ? shares : undefined, 1, kind !== 2] };
    const from = m.array("rest", rest, 3),
      to = m.array("posed", posed, 3);
    const extra =
      normals || posedNormals ? [...m.array("normals", normals, 3), ...m.array("posedNormals", posedNormals, 3)] : [];
    m.apart("posed", posed, { motions, shares, rest, normals });
    m.apart("posedNormals", posedNormals, { motions, shares, rest, normals, posed });
    mesh.fill(0);
    mesh.set([...from, ...to, ...extra]);
    run(this, "dq8_skin_pose", [kind, mesh.byteOffset], reads, {}, {}, SURFACE);
  }
}

const GLTF = "readGltf of dq8/gltf";
guesses(Dq8, {
  multiply: "mul",
  invert: "inverse",
  conjugate: "inverse",
  slerp: "sclerpEach",
  lerp: "sclerpEach",
  fromMatrices: "fromMatrices of dq8/gltf",
  toMatrices: "matrices",
  gltf: GLTF,
  loadGltf: GLTF,
  clip: "skeleton.clip",
  crowd: "skeleton.crowd",
  robot: "robot of dq8/robots",
});
guesses(Skeleton, { sample: "clip.sample", update: "palette", pose: "localToModel", bones: "joints" });
guesses(Skin, { update: "pose", apply: "pose" });
guesses(Clip, { pack: "pack of dq8/pack", times: "duration and frames" });
