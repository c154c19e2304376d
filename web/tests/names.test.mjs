// Names of JavaScript, C and Python beside those of Rust: what one language lacks has a reason here, and what this
// package has is in this table.
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { test } from "node:test";

const text = (path) => readFileSync(new URL(`../../${path}`, import.meta.url), "utf8");
const BORROWED = "C keeps what it has made itself",
  WHOLE = "Python has whole arrays, and no frame to keep within",
  NAMED = "made from arrays in one call";
const RECORDED = "robots and cars record trajectories and scans, and pages get them when they are put right";
/** A reason instead of a name. */
const none = (reason) => ({ reason });
/** Rust's file and name; JavaScript; C; Python. */
const TABLE = [
  ["src/hierarchy/skeleton.rs", "new", "skeleton", "check_parents", "class Hierarchy"],
  ["src/hierarchy/job.rs", "local_to_model", "localToModel", "local_to_model", "local_to_model"],
  ["src/hierarchy/job.rs", "model_to_local", "modelToLocal", "model_to_local", "model_to_local"],
  ["src/hierarchy/job.rs", "locals", "locals", none("C has packed clips alone"), none(WHOLE)],
  ["src/hierarchy/locals.rs", null, "poses", none("C has packed clips alone"), none(WHOLE)],
  ["src/hierarchy/job.rs", "palette", "palette", "palette_matrices", none(WHOLE)],
  ["src/hierarchy/job.rs", "palette", "modelPalette", none("of models, mul and matrices_4x4 have it"), none(WHOLE)],
  ["src/hierarchy/clip.rs", "new", "clip", none("C has packed clips alone"), none(WHOLE)],
  ["src/hierarchy/clip.rs", "new", "sample", none("C has packed clips alone"), none(WHOLE)],
  ["src/hierarchy/packed_clip.rs", "library", "pack", "clips_pack", "to_bytes"],
  ["src/hierarchy/packed_clip.rs", "from_bytes", "packedClip", "clips_make", "class PackedClip"],
  ["src/hierarchy/packed_clips.rs", "frames", "frames", none("dq8_clips_place cuts what lies beyond"), "frames"],
  ["src/hierarchy/packed_clips.rs", "duration", "duration", "clips_duration", "duration"],
  ["src/hierarchy/packed_clips.rs", "place", "sample", "clips_place", "sample"],
  ["src/hierarchy/layers.rs", "blend", "blend", none("C has packed clips alone"), none(WHOLE)],
  ["src/hierarchy/layers.rs", "add", "add", none("C has packed clips alone"), none(WHOLE)],
  ["src/hierarchy/crowd.rs", "new", "crowd", "block_size", none(WHOLE)],
  ["src/storage/packing.rs", "pack", "set", "pack", none(WHOLE)],
  ["src/hierarchy/crowd.rs", "copy_to_slice", "copyTo", "unpack", none(WHOLE)],
  [
    "src/scalar/two_bone.rs",
    "reach",
    "twoBone",
    none("limbs are not in the C interface yet"),
    none("limbs are not in Python yet"),
  ],
  ["src/skinning/skin.rs", "new", "skin", "skin_make", none(NAMED)],
  ["src/skinning/job.rs", "pose", "pose", "skin_dual", "skin"],
  ["src/slices/kernels.rs", "mul", "mul", "mul", "mul"],
  ["src/slices/kernels.rs", "sclerp_each", "sclerpEach", "sclerp_each", "sclerp"],
  ["src/slices/kernels.rs", "transform_points_each", "transformPointsEach", "points_each", "transform_points"],
  ["src/slices/transform.rs", "transform_points", "transformPoints", "points", "transform_points"],
  ["src/slices/kernels.rs", "conjugate", "inverse", "conjugate", "conjugate"],
  ["src/scalar/rigid.rs", "translation", "toRotationsTranslations", "motion_to_rotation_translation", "translation"],
  ["src/slices/matrix.rs", "matrices", "matrices", "matrices_4x4", "to_matrix"],
  [
    "src/scalar/rigid.rs",
    "from_rotation_translation",
    "fromRotationsTranslations",
    "motion_from_rotation_translation",
    "from_rotation_translation",
  ],
  ["robot/src/urdf/robot.rs", "from_urdf", "robot", none("C reads no files"), "from_urdf"],
  ["robot/src/urdf/robot.rs", "link", "link", none("C reads no files"), "links"],
  ["robot/src/mechanism/job.rs", "poses", "poses", "link_poses", "poses"],
  ["robot/src/mechanism/jacobians.rs", "jacobians", "jacobians", "mechanism_link_jacobian", "jacobian"],
  ["robot/src/ik/job.rs", "solve", "reach", "mechanism_reach", "reach"],
  ["robot/src/ik/job.rs", "solve_in", "reachEach", "reach", "reach"],
  ["robot/src/ik/job.rs", "follow", "follow", none("reach has an option"), none("reach has an option")],
  ["robot/src/ik/six_axis.rs", "solutions", "solutions", "solutions", "solutions"],
  ["src/scalar/blend.rs", "dib", none("of clips, blend has the mean of two"), "motion_mean", "mean"],
  ["trajectory/src/job.rs", "sample", none("clips are sampled by their frames"), "trajectory_sample", "sample"],
  ["trajectory/src/job.rs", "sample", none("clips are sampled by their frames"), "resample", "resample"],
  ["trajectory/src/path.rs", "new", none(RECORDED), none("C passes stamps and poses to each call"), "class Trajectory"],
  ["trajectory/src/job.rs", "deskew", none(RECORDED), "trajectory_deskew", "deskew"],
  ["trajectory/src/job.rs", "skew", none(RECORDED), "trajectory_skew", "skew"],
  ["trajectory/src/spline/job.rs", "sample", none("a page has squad and clips"), "spline_poses", "class Spline"],
  [
    "trajectory/src/compare/pairs.rs",
    "absolute",
    none(RECORDED),
    none("a comparison ends in text, not in arrays"),
    "compare",
  ],
  ["src/fit.rs", "rigid", none(RECORDED), none("fits are not in the C interface yet"), "fit_pairs"],
  ["src/storage/mod.rs", null, "floats", none("arrays are the caller's"), none("arrays are NumPy's")],
  ["src/storage/mod.rs", null, "subarray", none("arrays are the caller's"), none("arrays are NumPy's")],
  ["src/storage/mod.rs", null, "motions", none("arrays are the caller's"), none("arrays are NumPy's")],
  ["src/hierarchy/skeleton.rs", null, "free", none(BORROWED), none("Python collects what is not needed")],
];
const declared = ["dq8", "robots", "pack", "memory"].map((file) => text(`web/package/${file}.d.ts`)).join("\n");
const [c, python] = [text("capi/include/dq8.h"), text("python/package/dq8/_core.pyi")];
const word = (name) => new RegExp(`\\b${name.replace(/ /g, "\\s+")}\\b`);

test("every name in the table is there", () => {
  for (const [file, rust, js, inC, inPython] of TABLE) {
    // Kernels over slices are rows of a list.
    const declares = file === "src/slices/kernels.rs" ? `^ {4}${rust}\\b` : `pub fn ${rust}\\b`;
    if (rust) assert.match(text(file), new RegExp(declares, "m"), `Rust: ${file}: ${rust}`);
    if (js.reason) assert.ok(js.reason.length > 10);
    else assert.match(declared, new RegExp(`^\\s+${js}\\(`, "m"), `JavaScript: ${js}`);
    if (inC.reason) assert.ok(inC.reason.length > 10);
    else assert.match(c, new RegExp(`\\bdq8_${inC}(_f32)?\\(`), `C: ${inC}`);
    if (inPython.reason) assert.ok(inPython.reason.length > 10);
    else
      assert.match(
        python,
        inPython.startsWith("class") ? word(inPython) : new RegExp(`def ${inPython}\\(`),
        `Python: ${inPython}`,
      );
  }
});

test("every function that is declared is in the table", () => {
  const known = new Set(TABLE.map(([, , js]) => js));
  for (const [, name] of declared.matchAll(/^ {2}(\w+)\(/gm)) assert.ok(known.has(name), `${name} has no row`);
});

test("every method of the package is declared, and every export is called", () => {
  const files = ["dq8", "robots", "pack"].map((file) => text(`web/package/${file}.js`));
  const internal = new Set(["constructor", "write"]);
  for (const [, name] of files.join("\n").matchAll(/^ {2}(\w+)\(.*\{/gm)) {
    if (!internal.has(name) && !["for", "if"].includes(name))
      assert.match(declared, new RegExp(`\\b${name}\\(`), `${name} is not declared`);
  }
  const called = [...files, ...["memory", "sampled"].map((file) => text(`web/package/${file}.js`))].join("\n");
  const sources = readdirSync(new URL("../src", import.meta.url))
    .map((file) => text(`web/src/${file}`))
    .join("\n");
  for (const [, name] of sources.matchAll(/(?:fn |frees!\()(dq8_\w+)/g))
    assert.ok(called.includes(name), `${name} is called by nobody`);
});
