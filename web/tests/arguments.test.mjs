// Wrong arguments: a table of every method and its arrays, from which come the calls in which one of them is missing,
// no array, freed, of another module, short, or the same as one that is written. The error names the argument of the
// call and what is wrong with it, and nothing is written.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { before, describe, test } from "node:test";
import load from "../package/dq8.node.js";
import loadRobots from "../package/robots.node.js";

const text = (path) => readFileSync(new URL(`../../${path}`, import.meta.url), "utf8");
const URDF = text("robot/robots/arm7.urdf");
const KEYS = Float32Array.from({ length: 2 * 2 * 7 }, (_, i) => i % 7 === 3);
/** Joints, instances, vertices. */
const J = 2,
  N = 3,
  V = 4;

let dq8, other, robots, otherRobots, skeleton, clip, skin, crowd, robot, arm;
before(async () => {
  [dq8, other, robots, otherRobots] = await Promise.all([load(), load(), loadRobots(), loadRobots()]);
  skeleton = dq8.skeleton([-1, 0]);
  clip = skeleton.clip(KEYS);
  skin = dq8.skin({ jointCount: J, influences: 1, joints: [0, 1, 0, 1], weights: [1, 1, 1, 1] });
  crowd = skeleton.crowd(N);
  robot = robots.robot(URDF);
  arm = robots.robot(text("robot/robots/arm6.urdf"));
});

/**
 * A method of `of`, and its arrays, [what one element has, how many]: those that are read; those that are written;
 * those that may be missing. `call` calls it with arrays by their names.
 */
const ROWS = [
  {
    of: "Dq8",
    method: "fromRotationsTranslations",
    reads: { poses: [7, N] },
    writes: { motions: [8, N] },
    call: ({ poses, motions }) => dq8.fromRotationsTranslations(poses, motions),
  },
  {
    of: "Dq8",
    method: "mul",
    reads: { a: [8, N], b: [8, N] },
    writes: { product: [8, N] },
    call: ({ a, b, product }) => dq8.mul(a, b, product),
  },
  {
    of: "Dq8",
    method: "sclerpEach",
    reads: { a: [8, N], b: [8, N], t: [1, N] },
    writes: { between: [8, N] },
    call: ({ a, b, t, between }) => dq8.sclerpEach(a, b, t, between),
  },
  {
    of: "Dq8",
    method: "transformPointsEach",
    reads: { motions: [8, N], points: [3, N] },
    writes: { moved: [3, N] },
    call: ({ motions, points, moved }) => dq8.transformPointsEach(motions, points, moved),
  },
  {
    of: "Dq8",
    method: "matrices",
    reads: { motions: [8, N] },
    writes: { matrices: [16, N] },
    call: ({ motions, matrices }) => dq8.matrices(motions, matrices),
  },
  {
    of: "Skeleton",
    method: "localToModel",
    reads: { locals: [8, J * N], roots: [8, N] },
    writes: { models: [8, J * N] },
    optional: ["models", "roots"],
    call: ({ locals, models, roots }) => skeleton.localToModel(locals, models, { roots }),
  },
  {
    of: "Skeleton",
    method: "palette",
    reads: { locals: [8, J * N], roots: [8, N], inverseBinds: [8, J] },
    writes: { palette: [16, J * N] },
    optional: ["roots"],
    call: ({ locals, ...options }) => skeleton.palette(locals, options),
  },
  {
    of: "Skeleton",
    method: "palette",
    reads: { at: [1, N], layerAt: [1, N], weights: [1, N], mask: [1, J], inverseBinds: [8, J] },
    writes: { palette: [16, J * N] },
    optional: ["mask"],
    names: { layerAt: "layer.at" },
    call: ({ at, layerAt, weights, mask, ...options }) =>
      skeleton.palette(clip.sample(at).blend(clip.sample(layerAt), weights, { mask }), options),
  },
  {
    of: "Skeleton",
    method: "localToModel",
    reads: { at: [1, N], roots: [8, N] },
    writes: { models: [8, J * N] },
    optional: ["roots"],
    call: ({ at, models, roots }) => skeleton.localToModel(clip.sample(at), models, { roots }),
  },
  {
    of: "Skeleton",
    method: "modelPalette",
    reads: { models: [8, J * N], inverseBinds: [8, J] },
    writes: { palette: [16, J * N] },
    call: ({ models, ...options }) => skeleton.modelPalette(models, options),
  },
  {
    of: "Skeleton",
    method: "twoBone",
    reads: { targets: [3, N], poles: [3, N] },
    writes: { models: [8, 3 * N] },
    call: ({ models, targets, poles }) => dq8.skeleton([-1, 0, 1]).twoBone([0, 1, 2], models, targets, poles),
  },
  {
    of: "Dq8",
    method: "toRotationsTranslations",
    reads: { motions: [8, N] },
    writes: { poses: [7, N] },
    call: ({ motions, poses }) => dq8.toRotationsTranslations(motions, poses),
  },
  {
    of: "Dq8",
    method: "inverse",
    reads: { motions: [8, N] },
    writes: { inverses: [8, N] },
    call: ({ motions, inverses }) => dq8.inverse(motions, inverses),
  },
  {
    of: "Dq8",
    method: "transformPoints",
    reads: { motion: [8, 1], points: [3, N] },
    writes: { moved: [3, N] },
    call: ({ motion, points, moved }) => dq8.transformPoints(motion, points, moved),
  },
  {
    of: "Skeleton",
    method: "modelToLocal",
    reads: { models: [8, J * N], roots: [8, N] },
    writes: { locals: [8, J * N] },
    optional: ["roots"],
    call: ({ models, locals, roots }) => skeleton.modelToLocal(models, locals, { roots }),
  },
  {
    of: "Skeleton",
    method: "locals",
    reads: { at: [1, N], layerAt: [1, N], weights: [1, N], mask: [1, J], baseAt: [1, N] },
    writes: { locals: [8, J * N] },
    optional: ["mask"],
    names: { layerAt: "layer.at", baseAt: "base.layer.at", at: "base.at" },
    call: ({ at, layerAt, baseAt, weights, mask, locals }) => {
      const below = clip.sample(at).blend(clip.sample(baseAt), 0.5);
      skeleton.locals(below.add(clip.sample(layerAt), weights, { mask }), locals);
    },
  },
  {
    of: "Dq8",
    method: "poses",
    reads: { of: [8, J * N], at: [1, N] },
    writes: { models: [8, J * N] },
    names: { of: "locals", at: "layer.at" },
    call: ({ of, at, models }) => skeleton.localToModel(dq8.poses(of).blend(clip.sample(at), 0.5), models),
  },
  { of: "Crowd", method: "set", reads: { poses: [8, J * N] }, writes: {}, call: ({ poses }) => crowd.set(poses) },
  { of: "Crowd", method: "copyTo", reads: {}, writes: { poses: [8, J * N] }, call: ({ poses }) => crowd.copyTo(poses) },
  {
    of: "Crowd",
    method: "palette",
    reads: { inverseBinds: [8, J] },
    writes: { palette: [16, J * N] },
    call: (arrays) => crowd.palette(arrays),
  },
  {
    of: "Skin",
    method: "pose",
    reads: { motions: [8, J], shares: [1, V], rest: [3, V], normals: [3, V] },
    writes: { posed: [3, V], posedNormals: [3, V] },
    call: (arrays) => skin.pose({ blend: "mixed", ...arrays }),
  },
  {
    of: "Robot",
    method: "poses",
    robot: true,
    reads: { values: [1, 8 * N] },
    writes: { poses: [8, 11 * N] },
    call: ({ values, poses }) => robot.poses(values, poses),
  },
  {
    of: "Robot",
    method: "jacobians",
    robot: true,
    reads: { values: [1, 8 * N] },
    writes: { columns: [6, 8 * N] },
    call: ({ values, columns }) => robot.jacobians(1, values, columns),
  },
  {
    of: "Robot",
    method: "reach",
    robot: true,
    reads: { target: [8, 1] },
    writes: { values: [1, 8] },
    call: ({ target, values }) => robot.reach(1, target, values),
  },
  {
    of: "Robot",
    method: "reachEach",
    robot: true,
    reads: { targets: [8, N] },
    writes: { values: [1, 8 * N] },
    call: ({ targets, values }) => robot.reachEach(1, targets, values),
  },
  {
    of: "Robot",
    method: "follow",
    robot: true,
    reads: { targets: [8, N] },
    writes: { values: [1, 8 * N] },
    call: ({ targets, values }) => robot.follow(1, targets, values),
  },
  {
    of: "Robot",
    method: "solutions",
    robot: true,
    reads: { target: [8, 1], values: [1, 6] },
    writes: {},
    call: ({ target, values }) => arm.solutions(arm.linkNames.at(-1), target, values),
  },
];

for (const { of, method, reads, writes, optional = [], names = {}, robot: isRobot, call } of ROWS) {
  const sizes = { ...reads, ...writes },
    all = Object.keys(sizes);
  describe(`${of}.${method}(${all})`, () => {
    const arrays = (wrong = {}) => {
      const module = isRobot ? robots : dq8;
      return {
        ...Object.fromEntries(all.map((name) => [name, fill(module.floats(sizes[name][0] * sizes[name][1]))])),
        ...wrong,
      };
    };
    /** Identities, and numbers in them that the tests of outputs find again. */
    const fill = (numbers) => {
      numbers.view.fill(0);
      for (let i = 3; i < numbers.length; i += 8) numbers.view[i] = 1;
      return numbers;
    };
    const fails = (name, wrong, message) => {
      const given = arrays(wrong),
        outputs = Object.keys(writes).filter(
          (name) => given[name]?.length && given[name] instanceof dq8.floats(0).constructor,
        );
      for (const output of outputs) given[output].view?.fill(7);
      assert.throws(
        () => call(given),
        (error) => {
          assert.match(error.message, message);
          return true;
        },
        `${name}: no error`,
      );
      for (const output of outputs)
        if (!Object.values(reads).some((_, i) => given[Object.keys(reads)[i]] === given[output]))
          assert.ok(
            given[output].view.every((x) => x === 7),
            `${output} has been written to`,
          );
    };
    test("right arguments are none of this", () => {
      call(arrays());
    });
    for (const name of all) {
      const said = (names[name] ?? name).replace(".", "\\.");
      test(name, () => {
        const [size, length] = sizes[name],
          module = isRobot ? robots : dq8;
        const missing = new RegExp(`^${said} is missing$`);
        if (optional.includes(name)) call(arrays({ [name]: undefined }));
        else fails(name, { [name]: undefined }, missing);
        fails(
          name,
          { [name]: [1, 2, 3] },
          new RegExp(`^${said} is no array of ${isRobot ? "robots" : "dq8"}\\.floats$`),
        );
        const freed = module.floats(size * length);
        freed.free();
        fails(name, { [name]: freed }, new RegExp(`^${said} has been freed$`));
        fails(
          name,
          { [name]: (isRobot ? otherRobots : other).floats(size * length) },
          new RegExp(`^${said} is an array of another module$`),
        );
        if (size > 1)
          fails(
            name,
            { [name]: module.floats(size * length - 1) },
            new RegExp(`^${said} holds ${size * length - 1} numbers, which is not a multiple of ${size}$`),
          );
        // Of two arrays that do not fit, either may be named, but no array that the call does not have.
        const known = all
            .map((name) => names[name] ?? name)
            .concat("layer")
            .join("|"),
          unit = "(?:numbers?|points?|columns?|poses?|motions?|matri(?:x|ces))";
        fails(
          name,
          { [name]: module.floats(size * (length - 1)) },
          new RegExp(
            `^(?:${known}) holds (?:no|\\d+) ${unit}` +
              `(?: where \\d+ (?:is|are) needed|, which is not a multiple of the \\d+ \\w+)?$`,
          ),
        );
        for (const output of Object.keys(writes)) {
          if (output === name || (sizes[output][0] * sizes[output][1] !== size * length && size !== sizes[output][0]))
            continue;
          const both = module.floats(Math.max(size * length, sizes[output][0] * sizes[output][1]));
          if (name === "locals" && output === "models") continue; // in place
          fails(
            name,
            { [name]: both, [output]: both },
            new RegExp(`^(?:${output} is the same array as ${said}|${said} is the same array as ${output})$`),
          );
        }
      });
    }
  });
}

test("every method that takes arrays has a row", () => {
  const known = new Set(ROWS.map(({ method }) => method));
  // They make poses that other methods take, and are in the rows of those.
  const made = new Set(["sample", "blend", "add"]);
  for (const file of ["dq8", "robots"]) {
    for (const [, name, list] of text(`web/package/${file}.d.ts`).matchAll(/^ {2}(\w+)\(([^]*?)\): /gm)) {
      if (list.includes("Floats") || /SkinOptions|posed/.test(list))
        assert.ok(known.has(name) || made.has(name) || name === "skin", `${name} has no row`);
    }
  }
});

test("arguments that are no arrays of a module are named too", () => {
  const fails = (run, message) =>
    assert.throws(run, (error) => {
      assert.match(error.message, message);
      return true;
    });
  fails(() => dq8.floats(), /^source is undefined, neither a number nor an array$/);
  fails(() => dq8.floats(-1), /^length is -1, not a whole number$/);
  fails(() => dq8.skeleton(), /^parents is missing$/);
  fails(() => skeleton.clip(), /^keys is missing$/);
  fails(() => skeleton.crowd(), /^instances is missing$/);
  const whole = /^locals holds 3 motions, which is not a multiple of the 2 joints$/;
  fails(() => skeleton.localToModel(dq8.motions(3)), whole);
  fails(() => skeleton.palette(dq8.motions(2)), /^inverseBinds is missing$/);
  fails(() => skeleton.modelPalette(dq8.motions(2)), /^inverseBinds is missing$/);
  fails(() => dq8.packedClip(), /^bytes is missing$/);
  fails(() => dq8.skin(), /^jointCount is missing$/);
  const given = { jointCount: 2, influences: 1, joints: [0, 1], weights: [1, 1] };
  for (const name of Object.keys(given))
    fails(() => dq8.skin({ ...given, [name]: undefined }), new RegExp(`^${name} is missing$`));
  fails(
    () => dq8.skin({ ...given, influences: 4 }),
    /^joints holds 2 numbers, which is not a multiple of the 4 influences$/,
  );
  fails(() => dq8.skin({ ...given, weights: [1] }), /^weights holds 1 number where 2 are needed$/);
  fails(() => skin.pose(), /^rest is missing$/);
  fails(() => skin.pose({ normals: dq8.floats(12) }), /^rest is missing$/);
  fails(() => robots.robot(), /^urdf is missing$/);
  fails(() => robots.robot(null), /^urdf is neither text nor bytes$/);
  fails(() => robot.jacobians(undefined, robots.floats(8), robots.floats(54)), /^link is missing$/);
  fails(
    () => robot.poses(robots.floats(7), robots.floats(88)),
    /^values holds 7 numbers, which is not a multiple of the 8 values$/,
  );
});

test("nouns that have been freed say so by their names", () => {
  const fails = (run, message) =>
    assert.throws(run, (error) => {
      assert.match(error.message, message);
      return true;
    });
  const s = dq8.skeleton([-1]),
    c = s.clip(KEYS.slice(0, 14)),
    k = dq8.skin({ jointCount: 1, influences: 1, joints: [0], weights: [1] });
  const crowd = s.crowd(1),
    arm = robots.robot(URDF),
    sample = c.sample(dq8.floats(1));
  for (const noun of [c, k, crowd, arm]) {
    noun.free();
    noun.free();
  }
  fails(() => c.duration, /^the clip has been freed$/);
  fails(() => s.localToModel(sample, dq8.motions(1)), /^the clip has been freed$/);
  fails(
    () => k.pose({ motions: dq8.motions(1), rest: dq8.floats(3), posed: dq8.floats(3) }),
    /^the skin has been freed$/,
  );
  fails(() => crowd.set(dq8.motions(1)), /^the crowd has been freed$/);
  fails(() => arm.poses(robots.floats(8), robots.floats(88)), /^the robot has been freed$/);
  s.free();
  fails(() => s.localToModel(dq8.motions(1)), /^the skeleton has been freed$/);
});
