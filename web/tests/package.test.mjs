// The package in node, at every level that has been built, against the native library on the same input: with simd128
// to the last bit, with relaxed-simd within a bound.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { after, before, describe, test } from "node:test";
import load from "../package/dq8.node.js";
import loadPacker from "../package/pack.node.js";
import relaxed from "../package/relaxed.js";
import robotsRelaxed from "../package/robots-relaxed.js";
import loadRobots, { OUTCOMES } from "../package/robots.node.js";
import { CONFIGURATIONS, FRAMES, INSTANCES, JOINTS, VERTICES, given, parents } from "./given.mjs";

const URDF = new URL("../../robot/robots/arm7.urdf", import.meta.url);
const STRIDE = new URL("../../tests/firmware/jobs/src/stride.clips", import.meta.url);
const NATIVE = process.env.DQ8_ANSWERS ?? new URL("../target/debug/examples/answers", import.meta.url).pathname;
const urdf = readFileSync(URDF, "utf8");
/** Relaxed-simd rounds once or twice; a search may stop at a neighbour. Relative to the largest number of an answer. */
const BOUND = 4e-6,
  SEARCH = 2e-3;

let answers,
  read = 0;
before(() => {
  const input = Buffer.concat(Object.values(given).map((part) => Buffer.from(part.buffer)));
  const out = execFileSync(NATIVE, [URDF.pathname], { input, maxBuffer: 1 << 26 });
  answers = new Float32Array(out.buffer.slice(out.byteOffset, out.byteOffset + out.length));
});

function compare(level, what, got, bound = BOUND) {
  const expected = answers.subarray(read, read + got.length);
  read += got.length;
  assert.equal(expected.length, got.length, `${what}: as many answers`);
  const largest = expected.reduce((most, x) => Math.max(most, Math.abs(x)), 1);
  const bits = (of) => new Uint32Array(of.slice().buffer),
    [a, b] = [bits(got), bits(expected)];
  let worst = 0;
  for (let i = 0; i < got.length; i++) {
    if (level === "simd128") assert.ok(a[i] === b[i], `${what}[${i}] is ${got[i]}, natively ${expected[i]}`);
    worst = Math.max(worst, Math.abs(got[i] - expected[i]) / largest);
    assert.ok(Math.abs(got[i] - expected[i]) <= bound * largest, `${what}[${i}] is ${got[i]}, natively ${expected[i]}`);
  }
  return worst;
}

const built = (level) => existsSync(new URL(`../package/dq8.${level}.wasm`, import.meta.url));
const levels = (process.env.LEVELS ?? "simd128 relaxed").split(" ");

for (const level of levels)
  describe(level, { skip: !built(level) && "not built" }, () => {
    let dq8, robots, packer;
    const [core, arms] = level === "relaxed" ? [relaxed, robotsRelaxed] : [level, level];
    before(async () => {
      [dq8, robots, packer] = await Promise.all([load({ level: core }), loadRobots({ level: arms }), loadPacker()]);
    });

    test("answers are those of the native library", (t) => {
      read = 0;
      const check = (what, numbers, bound) => t.diagnostic(`${what}: ${compare(level, what, numbers.view, bound)}`);
      const motions = (from) => {
        const [poses, made] = [dq8.floats(from), dq8.motions(from.length / 7)];
        dq8.fromRotationsTranslations(poses, made);
        return made;
      };
      const skeleton = dq8.skeleton(parents),
        poses = INSTANCES * JOINTS;
      const [locals, roots, inverseBinds] = [given.locals, given.roots, given.binds].map(motions);
      const [atA, atB, weights, mask, spread, points] = ["atA", "atB", "weights", "mask", "t", "points"].map((name) =>
        dq8.floats(given[name]),
      );
      const models = dq8.motions(poses),
        plain = dq8.motions(poses),
        palette = dq8.floats(16 * poses),
        moved = dq8.floats(3 * poses);
      check("motions", locals);
      skeleton.localToModel(locals, plain);
      check("models", plain);
      models.view.set(locals.view);
      skeleton.localToModel(models, models, { roots });
      check("models on roots, in place", models);
      skeleton.palette(locals, { roots, inverseBinds, palette });
      check("palette", palette);
      const a = skeleton.clip(given.clipA).sample(atA),
        b = skeleton.clip(given.clipB).sample(atB);
      skeleton.localToModel(a, models);
      check("models of a clip", models);
      skeleton.palette(a.blend(b, weights), { roots, inverseBinds, palette });
      check("palette of two clips", palette);
      skeleton.palette(a.blend(b, weights, { mask }), { roots, inverseBinds, palette });
      check("palette of two clips, masked", palette);
      skeleton.localToModel(a.add(b, weights), models);
      check("models of one clip on another", models);
      // The native library has packed two clips.
      const bytes = () => {
        const [length, at] = [answers[read], read + 1];
        read = at + Math.ceil(length / 4);
        return new Uint8Array(answers.slice(at, read).buffer, 0, length);
      };
      const library = dq8.packedClip(bytes());
      const turning = [
        { keys: given.clipA, rate: 30 },
        { keys: given.clipB, loops: true },
      ];
      assert.deepEqual(packer.pack(JOINTS, turning, { angle: 1e-3, length: 0.5 }), bytes());
      assert.deepEqual([library.clips, library.frames(), library.frames(1), library.frames(2)], [2, FRAMES, FRAMES, 0]);
      assert.deepEqual(
        [library.duration(), library.duration(1), library.duration(2)],
        [(FRAMES - 1) / 2, (FRAMES - 1) / 0.5, 0],
      );
      const packed = library.sample(atA, dq8.floats(given.clips));
      skeleton.localToModel(packed, models);
      check("models of packed clips", models);
      skeleton.palette(packed.blend(library.sample(atB, 1), weights), { roots, inverseBinds, palette });
      check("palette of packed clips", palette);
      skeleton.palette(a.add(packed, weights, { mask }), { inverseBinds, palette });
      check("palette of packed clips on a plain one", palette);
      const one = dq8.motions(JOINTS),
        alone = dq8.floats(16 * JOINTS);
      skeleton.localToModel(library.sample(dq8.floats([1.25]), 1), one);
      check("one skeleton, packed", one);
      skeleton.palette(library.sample(dq8.floats([1.25]), 1), { inverseBinds, palette: alone });
      check("palette of one skeleton, packed", alone);
      const crowd = skeleton.crowd(INSTANCES);
      crowd.set(locals);
      crowd.localToModel();
      crowd.copyTo(models);
      check("models of a crowd", models);
      dq8.mul(locals, plain, models);
      check("products", models);
      dq8.sclerpEach(locals, plain, spread, models);
      check("between", models, 2e-5);
      dq8.transformPointsEach(plain, points, moved);
      check("points", moved);
      dq8.matrices(plain, palette);
      check("matrices", palette);
      const skin = dq8.skin({ jointCount: JOINTS, influences: 4, joints: given.joints, weights: given.skinWeights });
      const [rest, normals, shares] = ["rest", "normals", "shares"].map((name) => dq8.floats(given[name]));
      const [posed, posedNormals] = [dq8.floats(3 * VERTICES), dq8.floats(3 * VERTICES)];
      const first = dq8.motions(plain.view.slice(0, 8 * JOINTS));
      const room = dq8.floats(3 * VERTICES + 4),
        bare = room.subarray(0, 3 * VERTICES);
      for (const blend of ["dual", "linear", "mixed"]) {
        skin.pose({ blend, motions: first, shares, rest, posed, normals, posedNormals });
        check(`${blend} skin`, posed, 2e-5);
        check(`${blend} skin, normals`, posedNormals, 2e-5);
        room.view.fill(7);
        skin.pose({ blend, motions: first, shares, rest, posed: bare });
        assert.deepEqual(bare.view, posed.view, `${blend} skin: positions without normals have the same bits`);
        assert.deepEqual([...room.view.slice(-4)], [7, 7, 7, 7], `${blend} skin: nothing behind them is written`);
      }
      for (const influences of [1, 2, 3, 5]) {
        const count = influences * VERTICES,
          joints = Array.from({ length: count }, (_, i) => given.joints[i % given.joints.length]),
          weights = Array.from({ length: count }, (_, i) => 1 / (influences + (i % influences)));
        const few = dq8.skin({ jointCount: JOINTS, influences, joints, weights });
        few.pose({ blend: "linear", motions: first, rest, posed, normals, posedNormals });
        bare.view.fill(7);
        few.pose({ blend: "linear", motions: first, rest, posed: bare });
        assert.deepEqual(bare.view, posed.view, `${influences} influences: the same bits without normals`);
        few.free();
      }
      const robot = robots.robot(urdf),
        links = robot.linkNames.length,
        count = robot.valueNames.length;
      const values = robots.floats(given.values.slice(0, count * CONFIGURATIONS)),
        of = robots.floats(8 * links * CONFIGURATIONS);
      robot.poses(values, of);
      check("poses of links", of);
      const columns = robots.floats(6 * robot.rates * CONFIGURATIONS);
      robot.jacobians(links - 1, values, columns);
      check("Jacobians", columns);
      const goal = robots.floats(of.view.slice(8 * (2 * links - 1), 16 * links)),
        from = robots.floats(values.view.slice(0, count));
      const { outcome } = robot.reach(links - 1, goal, from);
      check("values that reach", from, SEARCH);
      assert.ok(OUTCOMES.includes(outcome));
      assert.equal(read, answers.length, "all answers");
    });

    test("a palette of models is the palette of their locals", () => {
      const skeleton = dq8.skeleton(parents),
        locals = dq8.motions(JOINTS * 9),
        binds = dq8.motions(JOINTS);
      locals.view.forEach((_, i, all) => {
        if (i % 8 > 3) all[i] = Math.sin(i);
      });
      locals.view.forEach((_, i, all) => {
        if (i % 8 === 7) all[i] = 0;
      });
      const [one, other] = [dq8.floats(16 * 9 * JOINTS), dq8.floats(16 * 9 * JOINTS)];
      skeleton.palette(locals, { inverseBinds: binds, palette: one });
      skeleton.localToModel(locals);
      skeleton.modelPalette(locals, { inverseBinds: binds, palette: other });
      assert.deepEqual(one.view, other.view);
    });

    test("a limb of two bones stands on its target, and its bones keep their length", () => {
      const skeleton = dq8.skeleton([-1, 0, 1, 2]),
        at = (i) => {
          const v = models.view,
            q = i * 8; // 2 q p*
          const [x, y, z, w, a, b, c, d] = v.subarray(q, q + 8);
          return [
            2 * (-d * x + a * w - b * z + c * y),
            2 * (-d * y + a * z + b * w - c * x),
            2 * (-d * z - a * y + b * x + c * w),
          ];
        };
      const models = dq8.motions(8),
        lengths = () =>
          [
            [0, 1],
            [1, 2],
            [2, 3],
          ].map(([i, j]) => Math.hypot(...at(i).map((x, k) => x - at(j)[k])));
      [
        [0, 1, 0],
        [0, 0.5, 0.1],
        [0, 0, 0],
        [0, 0, 0.2],
      ].forEach(([x, y, z], i) => models.view.set([x / 2, y / 2, z / 2], 8 * i + 4));
      models.view.set(models.view.slice(0, 32), 32);
      const before = lengths();
      skeleton.twoBone([0, 1, 2], models, dq8.floats([0.1, 0.3, 0.1, 0, 0.2, 0]), dq8.floats([0, 0, 1, 0, 0, 1]));
      at(2).forEach((x, k) => assert.ok(Math.abs(x - [0.1, 0.3, 0.1][k]) < 1e-6));
      lengths().forEach((length, i) => assert.ok(Math.abs(length - before[i]) < 1e-6));
      assert.ok(at(1)[2] > 0.2, "the knee is toward the pole");
      assert.throws(
        () => skeleton.twoBone([0, 2, 1], models, dq8.floats(6), dq8.floats(6)),
        /the third joint of the limb, 1, does not hang from 2/,
      );
      const rest = models.view.slice();
      assert.throws(
        () => skeleton.twoBone([0, 1, 2], models, dq8.floats([0, 0, 0, NaN, 0, 0]), dq8.floats(6)),
        /instance 1: /,
      );
      assert.deepEqual(models.view, rest, "an error moves nothing");
    });

    test("views survive growth", () => {
      const numbers = dq8.floats([1, 2, 3]),
        old = numbers.view;
      const more = dq8.floats(1 << 22);
      assert.equal(old.length, 0, "memory has grown under the view");
      assert.deepEqual([...numbers.view], [1, 2, 3]);
      assert.equal(numbers.view, numbers.view, "no view is made twice");
      const stride = readFileSync(STRIDE),
        cycle = () => {
          const s = dq8.skeleton(parents);
          s.crowd(1000).free();
          s.clip(given.clipA).free();
          dq8.packedClip(stride).free();
          s.free();
        };
      // Nouns have memory of their own, which no array gives back to them.
      cycle();
      const bytes = numbers.view.buffer.byteLength;
      for (let i = 0; i < 50; i++) {
        more.free();
        const again = dq8.floats(1 << 22);
        again.free();
      }
      assert.equal(numbers.view.buffer.byteLength, bytes, "what is freed is used again");
      for (let i = 0; i < 200; i++) cycle();
      assert.ok(numbers.view.buffer.byteLength <= bytes + (1 << 16));
    });

    test("errors are Rust's, and name the argument", () => {
      const skeleton = dq8.skeleton([-1, 0]),
        four = dq8.motions(4),
        three = dq8.motions(3),
        palette = dq8.floats(64);
      const fails = (run, text) =>
        assert.throws(run, (error) => {
          assert.match(error.message, text);
          return true;
        });
      fails(() => dq8.skeleton([-1, 2, 0]), /parent/);
      fails(() => dq8.skeleton([-1, 0.5]), /parents\[1\] is 0.5/);
      fails(() => skeleton.localToModel(three), /holds 3 motions, which is not a multiple of the 2 joints/);
      fails(() => skeleton.localToModel(four, dq8.motions(2)), /^models holds 2 motions where 4 are needed$/);
      fails(
        () => skeleton.palette(four, { inverseBinds: three, palette }),
        /^inverseBinds holds 3 motions where 2 are needed$/,
      );
      fails(
        () => skeleton.palette(four, { inverseBinds: palette, palette }),
        /^palette is the same array as inverseBinds$/,
      );
      fails(() => skeleton.palette(four, { palette }), /^inverseBinds is missing$/);
      fails(() => dq8.mul(four, dq8.floats(7), four), /^product is the same array as a$/);
      fails(() => dq8.mul(four, dq8.floats(7), dq8.motions(4)), /^b holds 7 numbers, which is not a multiple of 8$/);
      fails(() => skeleton.clip(new Float32Array(0)), /^keys holds no pose$/);
      for (const rate of [0, -30, NaN, Infinity])
        fails(() => skeleton.clip(given.clipA, { rate }), /^rate is .*, not a positive number$/);
      const clip = skeleton.clip(given.clipA.slice(0, 28)),
        at = dq8.floats(2);
      fails(
        () => skeleton.localToModel(clip.sample(at).blend(clip.sample(at), at, { mask: dq8.floats(0) }), four),
        /^mask holds 0 numbers where 2 are needed$/,
      );
      const stride = readFileSync(STRIDE),
        walk = dq8.packedClip(stride),
        damaged = Uint8Array.from(stride);
      damaged[8] = 7;
      fails(() => dq8.packedClip(damaged), /^not a packed clip file: unsupported version at byte 8$/);
      fails(() => dq8.packedClip([]), /at byte 0$/);
      fails(
        () => skeleton.localToModel(walk.sample(at), four),
        /^each frame of the clip holds 21 elements where 2 are needed$/,
      );
      fails(
        () => skeleton.localToModel(walk.sample(at, dq8.floats(1)), four),
        /^clips holds 1 number where 2 are needed$/,
      );
      for (const clip of [1, -1, 0.5, NaN])
        fails(
          () => skeleton.localToModel(walk.sample(at, dq8.floats([0, clip])), four),
          /^instance 1 is sampled at a place in other clips/,
        );
      fails(() => skeleton.localToModel(walk.sample(at, 1), four), /^instance 0 is sampled at a place in other clips/);
      fails(() => skeleton.localToModel(walk.sample(at, -1), four), /^clips is -1, not a whole number$/);
      const wrong = { jointCount: 2, influences: 1, joints: [0, 2], weights: [1, 1] };
      fails(() => dq8.skin(wrong), /vertex 1/);
      fails(() => dq8.skin({ ...wrong, joints: [0, -1] }), /^joints\[1\] is -1/);
      fails(() => dq8.skin({ ...wrong, joints: [0, 1], weights: [1, NaN] }), /weight/);
      const robot = robots.robot(urdf);
      fails(() => robots.robot("<robot name='x'><link/></robot>"), /line 1/);
      fails(() => robot.reach(99, robots.floats([0, 0, 0, 1, 0, 0, 0, 0]), robots.floats(8)), /link 99/);
      fails(() => robot.poses(robots.floats(3), robots.floats(88)), /values/);
      fails(() => robot.poses(four, robots.floats(88)), /^values is an array of another module$/);
      skeleton.free();
      fails(() => skeleton.localToModel(four), /^the skeleton has been freed$/);
      four.free();
      fails(() => four.view, /freed/);
      fails(() => dq8.mul(four, three, dq8.motions(3)), /^a has been freed$/);
    });

    test("joints of a skin cannot be written to", () => {
      const joints = Uint16Array.of(0, 1),
        weights = Float32Array.of(1, 1);
      const skin = dq8.skin({ jointCount: 2, influences: 1, joints, weights });
      joints.fill(60000);
      const posed = dq8.floats(6),
        rest = dq8.floats([1, 2, 3, 4, 5, 6]);
      skin.pose({ motions: dq8.motions(2), rest, posed });
      assert.deepEqual([...posed.view], [1, 2, 3, 4, 5, 6]);
      assert.deepEqual(Object.keys(skin), []);
    });

    test("a robot in Latin-1, and a target that is out of reach", () => {
      const latin = Buffer.from(
        urdf
          .replace('<?xml version="1.0"?>', '<?xml version="1.0" encoding="ISO-8859-1"?>')
          .replace('"base"/>', '"b\xe4se"/>')
          .replaceAll('link="base"', 'link="b\xe4se"'),
        "latin1",
      );
      assert.equal(robots.robot(new Uint8Array(latin)).linkNames[0], "b\xe4se");
      const robot = robots.robot(urdf),
        values = robots.floats(
          robot.valueNames.map((_, i) => robot.valueLimits[i][0] / 2 + robot.valueLimits[i][1] / 2),
        );
      const report = robot.reach(robot.link("hand"), robots.floats([0, 0, 0, 1, 5, 0, 0, 0]), values, {
        position: true,
      });
      assert.equal(report.outcome, "outOfReach");
      assert.ok(report.linearError > 8);
    });
  });

after(() => assert.ok(levels.some(built), "nothing has been built: web/build.sh"));
