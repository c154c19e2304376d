// Jobs and contenders: dq8, flat arrays by hand, gl-matrix, three.js. The same file in node and in a page. Answers are
// compared before anything is timed; contenders take turns, and the minimum of each counts.
import relaxed from "../package/relaxed.js";
import robotsRelaxed from "../package/robots-relaxed.js";
import { bits } from "../tests/bits.mjs";
import { animate, localToModel, skinDual, skinLinear } from "./plain.js";

const LEVELS = { simd128: [], relaxed: [relaxed, robotsRelaxed] };
const JOINTS = 64,
  FRAMES = 60,
  VERTICES = 32768,
  SKIN_JOINTS = 64;

export async function run({
  load,
  loadRobots,
  THREE,
  glMatrix,
  urdf,
  levels,
  instances = 400,
  people = 60,
  seconds = 2,
  clock = () => performance.now(),
  log = console.log,
}) {
  const { mat4, quat2 } = glMatrix,
    results = [];
  let seed = 1;
  const random = () => (seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0) / 2 ** 32,
    signed = () => 2 * random() - 1;
  const unit = () => {
    const q = [signed(), signed(), signed(), signed()],
      n = Math.hypot(...q);
    return q.map((x) => x / n);
  };
  const modules = await Promise.all(
    levels.map(async (level) => {
      const [core, arms] = LEVELS[level];
      return [level, await load({ level: core }), await loadRobots({ level: arms })];
    }),
  );

  for (const [level, dq8, robots] of modules) log(`${level} has the bits ${bits({ dq8, robots, urdf })}`);

  /**
   * Contenders are { name, run, answer, before }; the first that has an answer is what the others are compared with.
   */
  function contest(job, unitOf, per, bound, contenders) {
    let expected,
      worst = 0;
    for (const { name, run, answer, before } of contenders) {
      before?.();
      run();
      const got = Float32Array.from(answer());
      expected ??= got;
      if (got.length !== expected.length)
        throw new Error(`${job}: ${name} has ${got.length} numbers, not ${expected.length}`);
      for (let i = 0; i < got.length; i++) {
        const off = Math.abs(got[i] - expected[i]);
        if (!(off <= bound)) throw new Error(`${job}: ${name} has ${got[i]} at ${i}, not ${expected[i]}`);
        worst = Math.max(worst, off);
      }
    }
    // A turn lasts a millisecond, where it may be repeated: the clocks of browsers are coarse.
    const turns = contenders.map(({ run, before }) => {
      const start = performance.now();
      run();
      return before ? 1 : Math.ceil(1 / Math.max(0.02, performance.now() - start));
    });
    const best = contenders.map(() => Infinity),
      end = performance.now() + 1000 * seconds;
    let rounds = 0;
    do {
      for (const [i, { run, before }] of contenders.entries()) {
        const times = turns[i];
        before?.();
        const start = clock();
        for (let k = 0; k < times; k++) run();
        best[i] = Math.min(best[i], (clock() - start) / times);
      }
      rounds++;
    } while (performance.now() < end || rounds < 15);
    log(`${job} (ns per ${unitOf}; ${rounds} rounds; answers differ by ${worst.toExponential(1)} at most)`);
    for (const [i, { name, per: own = per }] of contenders.entries()) {
      const ns = (best[i] * 1e6) / own;
      results.push({ job, name, ns });
      const ratio = ns / ((best[0] * 1e6) / (contenders[0].per ?? per));
      log(`  ${name.padEnd(46)} ${ns.toFixed(2).padStart(9)}   ${ratio.toFixed(2).padStart(6)} x`);
    }
  }
  const each = (make) => modules.flatMap(([level, dq8, robots]) => make(level, dq8, robots));

  // A crowd. Offsets are small, so that numbers of models stay near 1.
  const parents = Int32Array.from({ length: JOINTS }, (_, j) =>
    j === 0 ? -1 : Math.max(0, j - 1 - Math.floor(3 * random())),
  );
  const count = instances * JOINTS,
    pose = new Float32Array(7 * count);
  for (let i = 0; i < count; i++) pose.set([...unit(), 0.1 * signed(), 0.2, 0.1 * signed()], 7 * i);
  const plainLocals = modules[0][1].motions(count),
    given = modules[0][1].floats(pose);
  modules[0][1].fromRotationsTranslations(given, plainLocals);
  const locals = plainLocals.view.slice(),
    flat = new Float32Array(8 * count);
  const glLocals = [],
    glModels = [];
  for (let i = 0; i < count; i++) {
    glLocals.push(quat2.clone(locals.subarray(8 * i, 8 * i + 8)));
    glModels.push(quat2.create());
  }
  const matLocals = [],
    matModels = [];
  for (const local of glLocals) {
    matLocals.push(mat4.fromQuat2(mat4.create(), local));
    matModels.push(mat4.create());
  }
  const loop = (multiply, from, to) => () => {
    for (let i = 0; i < count; i += JOINTS)
      for (let j = 0; j < JOINTS; j++) {
        if (parents[j] < 0) to[i + j].set(from[i + j]);
        else multiply(to[i + j], to[i + parents[j]], from[i + j]);
      }
  };
  /** Motions as matrices by columns, to be compared with those. */
  const matrices = (motions) =>
    Float32Array.from(
      Array.from({ length: motions.length / 8 }, (_, i) => [
        ...mat4.fromQuat2(mat4.create(), motions.subarray(8 * i, 8 * i + 8)),
      ]).flat(),
    );
  contest(`local to model, ${instances} x ${JOINTS}`, "bone", count, 2e-5, [
    ...each((level, dq8) => {
      const skeleton = dq8.skeleton(parents),
        [from, to] = [dq8.motions(locals), dq8.motions(count)],
        crowd = skeleton.crowd(instances);
      const out = () => matrices(to.view);
      return [
        {
          name: `dq8 ${level}, in blocks, in place`,
          run: () => crowd.localToModel(),
          before: () => crowd.set(from),
          answer: () => {
            crowd.copyTo(to);
            return out();
          },
        },
        {
          name: `dq8 ${level}, plain, in place`,
          run: () => skeleton.localToModel(to),
          before: () => to.view.set(from.view),
          answer: out,
        },
        { name: `dq8 ${level}, plain`, run: () => skeleton.localToModel(from, to), answer: out },
      ];
    }),
    {
      name: "flat dual quaternions by hand",
      run: () => localToModel(parents, locals, flat),
      answer: () => matrices(flat),
    },
    {
      name: "gl-matrix quat2",
      run: loop(quat2.multiply, glLocals, glModels),
      answer: () => matrices(Float32Array.from(glModels.flatMap((m) => [...m]))),
    },
    {
      name: "gl-matrix mat4",
      run: loop(mat4.multiply, matLocals, matModels),
      answer: () => matModels.flatMap((m) => [...m]),
    },
  ]);

  // Two clips of its own times for each, to 4×4 palettes.
  const clip = (phase, size) => {
    const keys = new Float32Array(7 * JOINTS * FRAMES);
    for (let f = 0; f < FRAMES; f++)
      for (let j = 0; j < JOINTS; j++) {
        const a = (size * Math.sin((f * 2 * Math.PI) / (FRAMES - 1) + j + phase)) / 2;
        keys.set([Math.sin(a), 0, 0, Math.cos(a), 0.01 * Math.sin(j + f), 0.2, 0], 7 * (f * JOINTS + j));
      }
    return keys;
  };
  const [a, b] = [clip(0, 0.4), clip(1, 0.7)];
  const [atA, atB, weights] = [0.37, 0.11, 0.7].map((step, k) =>
    Float32Array.from({ length: instances }, (_, i) => (i * step) % [59, 59, 1][k]),
  );
  const roots = new Float32Array(7 * instances),
    binds = new Float32Array(7 * JOINTS),
    flatPalette = new Float32Array(16 * count),
    scratch = new Float32Array(7 * JOINTS);
  for (let i = 0; i < instances; i++) roots.set([0, 0, 0, 1, 0.01 * i, 0, 0], 7 * i);
  for (let j = 0; j < JOINTS; j++) binds.set([...unit(), 0, (-0.2 * j) / JOINTS, 0], 7 * j);
  // three.js, of fewer people: how much memory its objects take decides how quick they are.
  const mixers = [],
    skeletons = [],
    some = Math.min(people, instances);
  for (let i = 0; i < some; i++) {
    const bones = Array.from(parents, () => new THREE.Bone()),
      root = new THREE.Object3D();
    bones.forEach((bone, j) => {
      bone.name = `b${j}`;
      (parents[j] < 0 ? root : bones[parents[j]]).add(bone);
    });
    root.position.set(roots[7 * i + 4], 0, 0);
    const times = Float32Array.from({ length: FRAMES }, (_, f) => f),
      mixer = new THREE.AnimationMixer(root),
      actions = [a, b].map((keys, k) => {
        const of = (j, first, n) =>
          Float32Array.from(
            { length: n * FRAMES },
            (_, c) => keys[7 * (Math.floor(c / n) * JOINTS + j) + first + (c % n)],
          );
        const tracks = bones.flatMap((_, j) => [
          new THREE.QuaternionKeyframeTrack(`b${j}.quaternion`, times, of(j, 0, 4)),
          new THREE.VectorKeyframeTrack(`b${j}.position`, times, of(j, 4, 3)),
        ]);
        const action = mixer.clipAction(new THREE.AnimationClip(`clip${k}`, FRAMES - 1, tracks));
        action.play();
        action.time = [atA, atB][k][i];
        action.setEffectiveWeight(k ? weights[i] : 1 - weights[i]);
        return action;
      });
    mixers.push({ mixer, root, actions });
    const inverse = Array.from({ length: JOINTS }, (_, j) =>
      new THREE.Matrix4().compose(
        new THREE.Vector3(...binds.subarray(7 * j + 4, 7 * j + 7)),
        new THREE.Quaternion(...binds.subarray(7 * j, 7 * j + 4)),
        new THREE.Vector3(1, 1, 1),
      ),
    );
    skeletons.push(new THREE.Skeleton(bones, inverse));
  }
  const first = (palette) => palette.slice(0, 16 * some * JOINTS);
  // three.js samples by slerp, all others by normalized lerp: 64 joints in a row add up what differs.
  contest(`two clips to 4x4 palettes, ${instances} x ${JOINTS} (three.js: ${some})`, "bone", count, 1e-2, [
    ...each((level, dq8) => {
      const skeleton = dq8.skeleton(parents),
        [r, m] = [roots, binds].map((from) => {
          const to = dq8.motions(from.length / 7);
          dq8.fromRotationsTranslations(dq8.floats(from), to);
          return to;
        });
      const [x, y, w] = [atA, atB, weights].map((from) => dq8.floats(from)),
        palette = dq8.floats(16 * count),
        [one, two] = [skeleton.clip(a), skeleton.clip(b)];
      return [
        {
          name: `dq8 ${level}`,
          run: () => skeleton.palette(one.sample(x).blend(two.sample(y), w), { roots: r, inverseBinds: m, palette }),
          answer: () => first(palette.view),
        },
      ];
    }),
    {
      name: "flat arrays by hand",
      run: () => animate({ parents, a, b, atA, atB, weights, roots, binds, palette: flatPalette, models: scratch }),
      answer: () => first(flatPalette),
    },
    {
      name: "three.js AnimationMixer, Skeleton.update",
      per: some * JOINTS,
      run: () => {
        for (let i = 0; i < some; i++) {
          mixers[i].mixer.update(0);
          mixers[i].root.updateMatrixWorld(true);
          skeletons[i].update();
        }
      },
      answer: () => skeletons.flatMap((skeleton) => [...skeleton.boneMatrices]),
    },
  ]);
  contest(`models and palettes alone, ${some} x ${JOINTS}`, "bone", some * JOINTS, 2e-3, [
    ...each((level, dq8) => {
      const skeleton = dq8.skeleton(parents),
        m = dq8.motions(JOINTS),
        r = dq8.motions(some),
        from = dq8.motions(some * JOINTS),
        palette = dq8.floats(16 * some * JOINTS);
      dq8.fromRotationsTranslations(dq8.floats(binds), m);
      dq8.fromRotationsTranslations(dq8.floats(roots.subarray(0, 7 * some)), r);
      const poses = Float32Array.from(
        mixers.flatMap((_, i) =>
          skeletons[i].bones.flatMap((bone) => [...bone.quaternion.toArray(), ...bone.position.toArray()]),
        ),
      );
      dq8.fromRotationsTranslations(dq8.floats(poses), from);
      return [
        {
          name: `dq8 ${level}`,
          run: () => skeleton.palette(from, { roots: r, inverseBinds: m, palette }),
          answer: () => palette.view,
        },
      ];
    }),
    {
      name: "three.js updateMatrixWorld, Skeleton.update",
      run: () => {
        for (let i = 0; i < some; i++) {
          mixers[i].root.updateMatrixWorld(true);
          skeletons[i].update();
        }
      },
      answer: () => skeletons.flatMap((skeleton) => [...skeleton.boneMatrices]),
    },
  ]);

  // A skin of four influences.
  const joints = Uint16Array.from({ length: 4 * VERTICES }, () => Math.floor(SKIN_JOINTS * random())),
    share = new Float32Array(4 * VERTICES);
  for (let v = 0; v < VERTICES; v++) {
    const w = [random(), random(), random(), random()],
      sum = w[0] + w[1] + w[2] + w[3];
    share.set(
      w.map((x) => x / sum),
      4 * v,
    );
  }
  const rest = Float32Array.from({ length: 3 * VERTICES }, signed),
    posed = new Float32Array(3 * VERTICES);
  // Poses that agree more or less: blends of opposite ones lose all digits, whoever blends.
  const motions = new Float32Array(8 * SKIN_JOINTS);
  for (let j = 0; j < SKIN_JOINTS; j++) {
    const q = [0.4 * signed(), 0.4 * signed(), 0.4 * signed(), 1],
      n = Math.hypot(...q);
    motions.set(
      quat2.fromRotationTranslation(
        quat2.create(),
        q.map((x) => x / n),
        [signed(), signed(), signed()],
      ),
      8 * j,
    );
  }
  const rows = Float32Array.from(
    Array.from({ length: SKIN_JOINTS }, (_, j) => {
      const m = mat4.fromQuat2(mat4.create(), motions.subarray(8 * j, 8 * j + 8));
      return [0, 1, 2].flatMap((r) => [m[r], m[4 + r], m[8 + r], m[12 + r]]);
    }).flat(),
  );
  const geometry = new THREE.BufferGeometry(),
    vertex = new THREE.Vector3();
  geometry.setAttribute("position", new THREE.BufferAttribute(rest, 3));
  geometry.setAttribute("skinIndex", new THREE.BufferAttribute(joints, 4));
  geometry.setAttribute("skinWeight", new THREE.BufferAttribute(share, 4));
  const mesh = new THREE.SkinnedMesh(geometry),
    bones = Array.from({ length: SKIN_JOINTS }, () => new THREE.Bone());
  mesh.bind(
    new THREE.Skeleton(
      bones,
      bones.map(() => new THREE.Matrix4()),
    ),
    new THREE.Matrix4(),
  );
  bones.forEach((bone, j) => {
    bone.matrixWorld.fromArray(mat4.fromQuat2(mat4.create(), motions.subarray(8 * j, 8 * j + 8)));
  });
  const skins = (blend) =>
    each((level, dq8) => {
      const skin = dq8.skin({ jointCount: SKIN_JOINTS, influences: 4, joints, weights: share }),
        [m, from, to] = [dq8.motions(motions), dq8.floats(rest), dq8.floats(rest.length)];
      return [
        {
          name: `dq8 ${level}, ${blend}`,
          run: () => skin.pose({ blend, motions: m, rest: from, posed: to }),
          answer: () => to.view.slice(),
        },
      ];
    });
  const byHand = {
    name: "flat arrays by hand, linear",
    run: () => skinLinear(joints, share, rows, rest, posed),
    answer: () => posed.slice(),
  };
  contest(`skin, ${VERTICES} vertices, linear`, "vertex", VERTICES, 2e-5, [
    ...skins("linear"),
    byHand,
    {
      name: "three.js applyBoneTransform",
      run: () => {
        for (let v = 0; v < VERTICES; v++) {
          vertex.fromArray(rest, 3 * v);
          mesh.applyBoneTransform(v, vertex);
          vertex.toArray(posed, 3 * v);
        }
      },
      answer: () => posed.slice(),
    },
  ]);
  contest(`skin, ${VERTICES} vertices, dual quaternions`, "vertex", VERTICES, 2e-5, [
    ...skins("dual"),
    {
      name: "flat arrays by hand, dual quaternions",
      run: () => skinDual(joints, share, motions, rest, posed),
      answer: () => posed.slice(),
    },
  ]);
  // Their answers differ, being another blend: timed beside the other for the ratio of the two.
  contest(`skin, ${VERTICES} vertices, linear by hand beside dual quaternions`, "vertex", VERTICES, Infinity, [
    ...skins("dual"),
    byHand,
  ]);

  // A robot.
  const CONFIGURATIONS = 200;
  const robot = modules[0][2].robot(urdf),
    links = robot.linkNames.length,
    values = Float32Array.from({ length: robot.valueNames.length * CONFIGURATIONS }, () => 0.03 * random());
  const zero = modules[0][2].floats(robot.valueNames.length),
    at0 = modules[0][2].floats(8 * links),
    atOne = modules[0][2].floats(8 * links);
  robot.poses(zero, at0);
  // Axes and offsets as the poses at one value at a time tell them: a revolute joint turns about its own z, the gripper
  // slides.
  const fixed = robot.parents.map((parent, j) => {
    const model = quat2.clone(at0.view.subarray(8 * j, 8 * j + 8));
    return mat4.fromQuat2(
      mat4.create(),
      parent < 0
        ? model
        : quat2.multiply(
            quat2.create(),
            quat2.conjugate(quat2.create(), quat2.clone(at0.view.subarray(8 * parent, 8 * parent + 8))),
            model,
          ),
    );
  });
  const moves = robot.valueNames
    .map((_, v) => {
      zero.view.fill(0);
      zero.view[v] = 0.02;
      robot.poses(zero, atOne);
      return robot.parents.flatMap((parent, j) => {
        const own = (from) => {
          const m = quat2.clone(from.view.subarray(8 * j, 8 * j + 8));
          return parent < 0
            ? m
            : quat2.multiply(
                quat2.create(),
                quat2.conjugate(quat2.create(), quat2.clone(from.view.subarray(8 * parent, 8 * parent + 8))),
                m,
              );
        };
        const moved = quat2.multiply(quat2.create(), quat2.conjugate(quat2.create(), own(at0)), own(atOne)),
          size = Math.hypot(moved[0], moved[1], moved[2]);
        if (size > 1e-4) return [{ j, v, axis: [0, 1, 2].map((c) => Math.round(moved[c] / size)) }];
        const slide = [0, 1, 2].map((c) => Math.round((2 * moved[4 + c]) / 0.02));
        return slide.some((x) => x) ? [{ j, v, slide }] : [];
      });
    })
    .flat();
  const bodies = robot.parents.map(() => mat4.create()),
    own = mat4.create(),
    identity = mat4.create(),
    out = new Float32Array(16 * links * CONFIGURATIONS);
  const of = Array.from({ length: links }, (_, j) => moves.find((move) => move.j === j)),
    n = robot.valueNames.length;
  const glRobot = () => {
    for (let c = 0; c < CONFIGURATIONS; c++)
      for (let j = 0; j < links; j++) {
        const move = of[j],
          up = robot.parents[j];
        mat4.multiply(bodies[j], up < 0 ? identity : bodies[up], fixed[j]);
        if (move) {
          const x = values[c * n + move.v];
          mat4.multiply(
            bodies[j],
            bodies[j],
            move.axis
              ? mat4.fromRotation(own, x, move.axis)
              : mat4.fromTranslation(
                  own,
                  move.slide.map((s) => s * x),
                ),
          );
        }
        out.set(bodies[j], 16 * (c * links + j));
      }
  };
  contest(`poses of all links of a robot, ${CONFIGURATIONS} x ${links}`, "configuration", CONFIGURATIONS, 2e-5, [
    ...each((level, _, robots) => {
      const it = robots.robot(urdf),
        [v, to] = [robots.floats(values), robots.floats(8 * links * CONFIGURATIONS)];
      return [{ name: `dq8 ${level}`, run: () => it.poses(v, to), answer: () => matrices(to.view) }];
    }),
    { name: "gl-matrix mat4", run: glRobot, answer: () => out },
  ]);
  return results;
}
