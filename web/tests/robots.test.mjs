// Robots: many targets as one at a time, bases and tools as motions before and after, all solutions by their poses.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { before, describe, test } from "node:test";
import load from "../package/dq8.node.js";
import loadRobots from "../package/robots.node.js";

const file = (name) => readFileSync(new URL(`../../robot/robots/${name}.urdf`, import.meta.url), "utf8");
const [ARM6, ARM7] = [file("arm6"), file("arm7")];
const COUNT = 11;

let dq8, robots;
before(async () => {
  [dq8, robots] = await Promise.all([load(), loadRobots()]);
});

let state = 7;
const random = () => (state = (Math.imul(state, 1664525) + 1013904223) >>> 0) / 2 ** 32;
const middle = ({ valueLimits }) =>
  valueLimits.map(([low, high]) => (Number.isFinite(low + high) ? (low + high) / 2 : 0.1));
/** Configurations within the limits. */
const somewhere = (robot, count) =>
  Float32Array.from({ length: count * robot.valueNames.length }, (_, i) => {
    const [low, high] = robot.valueLimits[i % robot.valueNames.length],
      part = 0.1 + 0.8 * random();
    return Number.isFinite(low + high) ? low + part * (high - low) : 4 * part - 2;
  });
/** [configuration][link] */
function posesOf(robot, values) {
  const configurations = values.length / robot.valueNames.length,
    poses = robots.motions(configurations * robot.linkNames.length);
  robot.poses(values, poses);
  return poses.view;
}
/** The poses of one link, of values as an array of numbers. */
function posesAt(robot, link, values) {
  const of = robots.floats(values),
    stride = 8 * robot.linkNames.length,
    poses = posesOf(robot, of);
  const first = 8 * robot.link(link);
  return Float32Array.from(
    { length: (8 * poses.length) / stride },
    (_, i) => poses[Math.floor(i / 8) * stride + first + (i % 8)],
  );
}
const pose = (...numbers) => {
  const [from, to] = [dq8.floats(numbers), dq8.motions(1)];
  dq8.fromRotationsTranslations(from, to);
  return robots.motions(to.view);
};
/** Products of as many motions, by the other module. */
function mul(a, b) {
  const [left, right, product] = [a, b, b.length].map((from) => dq8.floats(from));
  dq8.mul(left, right, product);
  return product.view.slice();
}
const near = (got, expected, bound) => {
  assert.equal(got.length, expected.length);
  const sign = (of, i) => Math.sign(of[i + 3]);
  got.forEach((x, i) => {
    const first = i - (i % 8),
      turned = sign(got, first) === sign(expected, first) ? 1 : -1;
    assert.ok(Math.abs(x - turned * expected[i]) < bound, `[${i}] is ${x}, not ${expected[i]}`);
  });
};
const fails = (run, message) =>
  assert.throws(run, (error) => {
    assert.match(error.message, message);
    return true;
  });

describe("many targets", () => {
  for (const options of [{}, { position: true }, { restarts: false }]) {
    test(`are reached as one at a time, to the last bit: ${JSON.stringify(options)}`, () => {
      const robot = robots.robot(ARM7),
        n = robot.valueNames.length;
      const targets = robots.motions(posesAt(robot, "hand", somewhere(robot, COUNT))),
        start = Array.from({ length: COUNT }, () => middle(robot)).flat();
      // One is out of reach, and one is no motion.
      targets.view.set([0, 0, 0, 1, 25, 0, 0, 0], 8 * 3);
      targets.view.fill(NaN, 8 * 5, 8 * 6);
      const all = robots.floats(start),
        reports = robot.reachEach("hand", targets, all, options);
      assert.equal(reports.length, COUNT);
      for (let i = 0; i < COUNT; i++) {
        const target = robots.motions(targets.view.slice(8 * i, 8 * i + 8)),
          alone = robots.floats(start.slice(0, n));
        assert.deepEqual(robot.reach("hand", target, alone, options), reports[i]);
        assert.deepEqual(all.view.slice(n * i, n * i + n), alone.view.slice());
      }
      assert.deepEqual(
        [3, 5].map((i) => reports[i].outcome),
        ["outOfReach", "invalid"],
      );
      const reached = reports.flatMap(({ outcome }, i) => (outcome === "converged" ? [i] : []));
      assert.ok(reached.length >= (options.restarts === false ? 1 : COUNT - 2));
      const found = posesAt(robot, "hand", all.view.slice());
      for (const i of reached) {
        const part = (of) => of.slice(8 * i, 8 * i + 8);
        if (!options.position) near(part(found), part(targets.view), 1e-4);
      }
    });
  }

  test("that move are followed from where the values are, and no search begins elsewhere", () => {
    const robot = robots.robot(ARM7),
      values = robots.floats(Array.from({ length: 3 }, () => middle(robot)).flat());
    const targets = robots.motions(posesAt(robot, "hand", values.view.slice()));
    const moved = (from) =>
      mul(
        Float32Array.from({ length: from.length }, (_, i) => [0, 0, 0, 1, 0.001, 0, 0, 0][i % 8]),
        from,
      );
    for (let frame = 0; frame < 20; frame++) {
      const before = values.view.slice();
      targets.view.set(moved(targets.view));
      const other = robots.floats(before),
        reports = robot.follow("hand", targets, values);
      assert.deepEqual(robot.reachEach("hand", targets, other, { restarts: false }), reports);
      assert.deepEqual(other.view, values.view);
      for (const { outcome, restarts } of reports) assert.deepEqual([outcome, restarts], ["converged", 0]);
      values.view.forEach((x, i) => assert.ok(Math.abs(x - before[i]) < 0.2));
    }
    // A hand cannot be where the base is.
    targets.view.set([0, 0, 0, 1, 0, 0, 0, 0]);
    assert.ok(robot.reachEach("hand", targets, robots.floats(values))[0].restarts > 0);
    assert.equal(robot.follow("hand", targets, values)[0].restarts, 0);
  });

  test("are none, or as many as there are configurations", () => {
    const robot = robots.robot(ARM7),
      values = robots.floats(middle(robot)),
      rest = values.view.slice();
    assert.deepEqual(robot.reachEach("hand", robots.motions(0), robots.floats(0)), []);
    fails(() => robot.reachEach("hand", robots.motions(2), values), /^values holds 8 numbers where 16 are needed$/);
    fails(() => robot.reach("hand", robots.motions(2), values), /^target holds 2 motions where 1 is needed$/);
    fails(() => robot.follow("hnd", robots.motions(1), values), /^link is hnd, none of base, /);
    assert.deepEqual(values.view, rest);
  });

  test("of two links in turns are those of each link", () => {
    const robot = robots.robot(ARM7),
      names = ["hand", robot.linkNames[3]],
      reach = (robot, name) => {
        const values = robots.floats(middle(robot)),
          target = robots.motions(posesAt(robot, name, somewhere(robot, 1)));
        const report = robot.reach(name, target, values, { position: true });
        return [report, ...values.view];
      };
    state = 9;
    const turns = [0, 1, 0, 1].map((i) => reach(robot, names[i]));
    state = 9;
    assert.deepEqual(
      [0, 1, 0, 1].map((i) => reach(robots.robot(ARM7), names[i])),
      turns,
    );
  });
});

describe("all solutions", () => {
  test("bring the tool to the target, nearest first, and the given values are one of them", () => {
    const robot = robots.robot(ARM6),
      tool = robot.linkNames.at(-1);
    let most = 0;
    for (let round = 0; round < 20; round++) {
      const start = somewhere(robot, 1),
        target = robots.motions(posesAt(robot, tool, start)),
        { family, isComplete, found } = robot.solutions(tool, target, robots.floats(start));
      assert.ok(family !== "other" && isComplete);
      most = Math.max(most, found.length);
      found.forEach(({ values, distance }, i) => {
        near(posesAt(robot, tool, values), target.view, 2e-4);
        assert.ok(i === 0 || distance >= found[i - 1].distance);
        const far = Math.hypot(...values.map((x, k) => x - start[k]));
        assert.ok(Math.abs(far - distance) < 1e-4);
        values.forEach((x, k) => {
          const [low, high] = robot.valueLimits[k];
          assert.ok(x >= low - 1e-5 && x <= high + 1e-5);
        });
      });
      assert.ok(found[0].distance < 5e-3, `${found[0].distance}`);
      for (const [i, one] of found.entries())
        for (const other of found.slice(0, i))
          assert.ok(
            one.values.some((x, k) => Math.abs(x - other.values[k]) > 1e-3) ||
              Object.values(one.singular).some(Boolean),
          );
    }
    assert.ok(most >= 4, `at most ${most}`);
  });

  test("are none out of reach, and are of arms of six hinges alone", () => {
    const robot = robots.robot(ARM6),
      values = robots.floats(6),
      far = robots.motions([0, 0, 0, 1, 9, 0, 0, 0]);
    assert.deepEqual(robot.solutions(robot.linkNames.at(-1), far, values).found, []);
    fails(
      () => robot.solutions(robot.linkNames.at(-1), far, robots.floats(5)),
      /^values holds 5 numbers where 6 are needed$/,
    );
    fails(
      () => robot.solutions(robot.linkNames.at(-1), robots.motions([0, 0, 0, 2, 0, 0, 0, 0]), values),
      /^target 0 is not a unit motion/,
    );
    const seven = robots.robot(ARM7);
    fails(() => seven.solutions("hand", far, robots.floats(8)), /^7 hinges carry the link, not six$/);
  });
});

describe("what a robot stands on and holds", () => {
  test("poses of a robot on a base are the base times those without it", () => {
    const [base, plain] = [pose(0.6, 0, 0, 0.8, 1, 2, 3), robots.robot(ARM7)],
      robot = robots.robot(ARM7, { base });
    const values = robots.floats(somewhere(plain, 1)),
      each = Float32Array.from({ length: 8 * plain.linkNames.length }, (_, i) => base.view[i % 8]);
    near(posesOf(robot, values), mul(each, posesOf(plain, values).slice()), 2e-6);
    assert.deepEqual(robot.linkNames, plain.linkNames);
  });

  test("a floating base has seven values and six rates before all others", () => {
    const [at, plain] = [[0, 0.6, 0, 0.8, 3, 2, 1], robots.robot(ARM7)],
      robot = robots.robot(ARM7, { floating: true });
    const names = ["qx", "qy", "qz", "qw", "x", "y", "z"].map((part) => `root_joint.${part}`);
    assert.deepEqual(robot.valueNames, [...names, ...plain.valueNames]);
    assert.equal(robot.rates, 6 + plain.rates);
    const values = somewhere(plain, 1),
      base = pose(...at).view,
      each = Float32Array.from({ length: 8 * plain.linkNames.length }, (_, i) => base[i % 8]);
    const got = posesOf(robot, robots.floats([...at, ...values]));
    near(got, mul(each, posesOf(plain, robots.floats(values)).slice()), 2e-6);
    assert.deepEqual(robot.valueLimits[0], [-Infinity, Infinity]);
  });

  test("a tool is a link at its pose on another, and can be given by its name", () => {
    const [grip, tip] = [pose(0, 0, 0.6, 0.8, 0.1, 0, 0), pose(0, 0, 0, 1, 0, 0, 0.2)];
    const tools = [
      { name: "grip", link: "hand", pose: grip },
      { name: "tip", link: "grip", pose: tip },
    ];
    const robot = robots.robot(ARM7, { tools }),
      values = somewhere(robot, 1);
    assert.deepEqual(robot.linkNames.slice(-2), ["grip", "tip"]);
    assert.equal(robot.parents[robot.link("tip")], robot.link("grip"));
    const hand = posesAt(robot, "hand", values);
    near(posesAt(robot, "tip", values), mul(mul(hand, grip.view), tip.view), 2e-6);
    const found = robots.floats(middle(robot)),
      target = robots.motions(posesAt(robot, "tip", values));
    assert.equal(robot.reach("tip", target, found).outcome, "converged");
    near(posesAt(robot, "tip", found.view.slice()), target.view, 1e-4);
  });

  test("what cannot be is said by its name, and leaves no memory behind", () => {
    const one = robots.motions(1),
      made = (options) => () => robots.robot(ARM7, options),
      tool = (changes) => made({ tools: [{ name: "grip", link: "hand", pose: one, ...changes }] });
    fails(made({ floating: true, base: one }), /^a base that is floating stands at no base$/);
    fails(made({ base: robots.motions(2) }), /^base holds 2 motions where 1 is needed$/);
    fails(made({ base: dq8.motions(1) }), /^base is an array of another module$/);
    fails(made({ base: robots.motions([0, 0, 0, 2, 0, 0, 0, 0]) }), /joint 0 is not a unit dual quaternion/);
    fails(tool({ link: "hnd" }), /^the robot has no link "hnd"; its links are base, /);
    fails(tool({ name: "hand" }), /^the robot already has a link or joint with the name "hand"$/);
    fails(tool({ name: undefined }), /^tools\[0\]\.name is no name$/);
    fails(tool({ pose: undefined }), /^tools\[0\]\.pose is missing$/);
    const bytes = one.view.buffer.byteLength;
    for (let i = 0; i < 300; i++) {
      fails(tool({ link: "hnd" }), /hnd/);
      robots.robot(ARM7, { base: one }).free();
    }
    assert.ok(one.view.buffer.byteLength <= bytes + (1 << 17));
  });
});

test("names of links may hold any characters of a file", () => {
  const names = ["a&#9;b", "c&#10;d", "é 1"],
    links = names.map((name) => `<link name="${name}"/>`).join("");
  const joint = (i) =>
    `<joint name="j${i}" type="fixed"><parent link="${names[i]}"/><child link="${names[i + 1]}"/></joint>`;
  const robot = robots.robot(`<robot name="r">${links}${joint(0)}${joint(1)}</robot>`);
  assert.deepEqual(robot.linkNames, ["a\tb", "c\nd", "é 1"]);
  assert.deepEqual([robot.valueNames, robot.parents, robot.link("é 1")], [[], [-1, 0, 1], 2]);
});
