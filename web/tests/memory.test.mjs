// Memory of arrays is given to arrays alone: views that outlive their array reach nothing that has been checked.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import load from "../package/dq8.node.js";
import loadRobots from "../package/robots.node.js";

const read = (path) => readFileSync(new URL(`../../${path}`, import.meta.url));
const URDF = read("robot/robots/arm7.urdf").toString(),
  STRIDE = read("tests/firmware/jobs/src/stride.clips");
const VERTICES = 3000,
  JOINTS = 21;

/** Makes one noun of each kind, and what asks all of them for their answers. */
function nouns(dq8, robots) {
  const keys = Float32Array.from({ length: 40 * JOINTS * 7 }, (_, i) =>
    i % 7 === 3 ? 1 : i % 7 > 3 ? Math.sin(i) : 0,
  );
  const skeleton = dq8.skeleton(Array.from({ length: JOINTS }, (_, joint) => joint - 1));
  const clip = skeleton.clip(keys),
    packed = dq8.packedClip(STRIDE),
    crowd = skeleton.crowd(50),
    robot = robots.robot(URDF);
  const each = Array.from({ length: 4 * VERTICES }, (_, i) => i % JOINTS);
  const skin = dq8.skin({ jointCount: JOINTS, influences: 4, joints: each, weights: each.map(() => 0.25) });
  const start = dq8.motions(50 * JOINTS);
  crowd.set(start);
  start.free();
  const made = [skeleton, clip, packed, crowd, skin, robot];
  return {
    free() {
      for (const noun of made) noun.free();
    },
    answers() {
      const kept = [],
        floats = (of, n) => {
          const array = of.floats(n);
          kept.push(array);
          return array;
        };
      const at = floats(dq8, [1.5, 7.25]),
        models = floats(dq8, 2 * JOINTS * 8),
        blended = floats(dq8, 2 * JOINTS * 8);
      skeleton.localToModel(clip.sample(at), models);
      skeleton.localToModel(packed.sample(at).blend(clip.sample(at), at), blended);
      const poses = floats(dq8, 50 * JOINTS * 8),
        posed = floats(dq8, 3 * VERTICES);
      crowd.localToModel();
      crowd.copyTo(poses);
      const rest = floats(
        dq8,
        Array.from({ length: 3 * VERTICES }, (_, i) => Math.cos(i)),
      );
      const motions = floats(dq8, models.view.slice(0, 8 * JOINTS));
      skin.pose({ blend: "linear", motions, rest, posed });
      const values = floats(robots, robot.valueNames.length),
        links = floats(robots, 8 * robot.linkNames.length);
      robot.poses(values, links);
      const target = floats(robots, [0, 0, 0, 1, 0.1, 0.1, 0.2, 0]),
        { outcome } = robot.reach(3, target, values, { position: true });
      const all = [models, blended, poses, posed, links, values].map(({ view }) => [...view]);
      for (const array of kept) array.free();
      return [...all, outcome];
    },
  };
}

test("views that outlive their arrays write into no skeleton, clip, crowd, skin or robot", async () => {
  const [dq8, robots] = await Promise.all([load(), loadRobots()]);
  // Memory has grown as far as it will: a view that is detached would write nothing.
  nouns(dq8, robots).free();
  const expected = nouns(dq8, robots);
  const answers = expected.answers();
  expected.free();
  const stale = [dq8, robots]
    .flatMap((module) =>
      [1e6, 12000, 6000, 3000, 1000, 300, 40, 8, 1].flatMap((length) => {
        const arrays = Array.from({ length: 9 }, () => module.floats(length)),
          views = arrays.map(({ view }) => view);
        for (const array of arrays) array.free();
        return views;
      }),
    )
    .filter((view) => view.length > 0);
  assert.ok(stale.length > 60, "of all sizes");
  const made = nouns(dq8, robots),
    reaching = () => stale.filter((view) => view.length > 0);
  assert.ok(reaching().length > 60, "views are not detached");
  for (const view of stale) view.fill(1e9);
  assert.deepEqual(made.answers(), answers);
  for (const view of stale) new Uint32Array(view.buffer, view.byteOffset, view.length).fill(0xffffffff);
  assert.deepEqual(made.answers().at(-1), answers.at(-1));
});

test("no two arrays share memory, new ones are zero, and what is freed is used again", async () => {
  const dq8 = await load();
  let state = 1,
    most = 0;
  const random = (below) => (state = (Math.imul(state, 1664525) + 1013904223) >>> 0) % below,
    live = new Map();
  for (let round = 0; round < 4000; round++) {
    if (live.size > 60 || random(3) === 0) {
      const [id, array] = [...live][random(Math.max(1, live.size))] ?? [];
      if (id === undefined) continue;
      assert.ok(
        array.view.every((x) => x === id),
        `array ${id} of ${array.length} numbers has been written to`,
      );
      array.free();
      live.delete(id);
    } else {
      const array = dq8.floats(random(random(4) ? 300 : 20000));
      assert.ok(
        array.view.every((x) => x === 0),
        "a new array is zero",
      );
      array.view.fill(round + 1);
      live.set(round + 1, array);
    }
    most = Math.max(
      most,
      [...live.values()].reduce((sum, { length }) => sum + 4 * length, 0),
    );
  }
  for (const array of live.values()) array.free();
  const after = dq8.floats(0).view.buffer.byteLength;
  assert.ok(after < 3 * most + 3e6, `${after} bytes for ${most}`);
  const half = dq8.floats(Math.floor(most / 8));
  assert.equal(half.view.buffer.byteLength, after, "what is free is one piece again");
});
