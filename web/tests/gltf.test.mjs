// Files that the tests write, read by `dq8/gltf` and by three.js: palettes are the same, and what has none is named.
import assert from "node:assert/strict";
import { before, describe, test } from "node:test";
import * as three from "../bench/node_modules/three/build/three.module.js";
import { GLTFLoader } from "../bench/node_modules/three/examples/jsm/loaders/GLTFLoader.js";
import load from "../package/dq8.node.js";
import { readGltf, readThree } from "../package/gltf.js";
import { File } from "./glb.mjs";

const BOUND = 1e-5,
  RATE = 30;
let dq8;
before(async () => {
  dq8 = await load();
});

const unit = (q) => {
  const n = Math.hypot(...q);
  return q.map((x) => x / n);
};
/** The inverse of the world matrix that nodes have at rest. */
function binds(nodes, joints) {
  const up = new Map(nodes.flatMap(({ children = [] }, i) => children.map((child) => [child, i])));
  const local = ({ matrix, rotation = [0, 0, 0, 1], translation = [0, 0, 0], scale = [1, 1, 1] }) =>
    matrix
      ? new three.Matrix4().fromArray(matrix)
      : new three.Matrix4().compose(
          new three.Vector3(...translation),
          new three.Quaternion(...rotation),
          new three.Vector3(...scale),
        );
  const world = (i) => (up.has(i) ? world(up.get(i)).multiply(local(nodes[i])) : local(nodes[i]));
  return joints.flatMap((joint) => world(joint).invert().toArray());
}
/** A triangle for each joint; `sets` of four joints for each vertex. */
function triangles(file, joints, sets = 1) {
  const at = Array.from({ length: 9 * joints }, (_, i) => Math.sin(i)),
    vertices = 3 * joints,
    attributes = { POSITION: file.accessor("VEC3", at) };
  for (let k = 0; k < sets; k++) {
    attributes[`JOINTS_${k}`] = file.accessor(
      "VEC4",
      Uint8Array.from({ length: 4 * vertices }, (_, i) => (i + 3 * k) % joints),
    );
    attributes[`WEIGHTS_${k}`] = file.accessor(
      "VEC4",
      Array.from({ length: 4 * vertices }, (_, i) => (1 + ((i + k) % 4)) / 10 / sets),
    );
  }
  return { attributes };
}
/** Channels [node, path, times, values, interpolation] as an animation. */
function animation(file, name, channels) {
  return {
    name,
    channels: channels.map(([node, path], sampler) => ({ target: { node, path }, sampler })),
    samplers: channels.map(([, path, times, values, interpolation]) => ({
      input: file.accessor("SCALAR", times),
      interpolation,
      output: typeof values === "number" ? values : file.accessor(path === "rotation" ? "VEC4" : "VEC3", values.flat()),
    })),
  };
}
const turns = (times, axis, size) =>
  times.map((t) => {
    const half = (size * Math.sin(3 * t + axis)) / 2;
    const q = [0, 0, 0, Math.cos(half)];
    q[axis % 3] = Math.sin(half);
    return unit(q);
  });
const steps = (times, size) => times.map((t) => [size * Math.sin(t), size + size * Math.cos(2 * t), -size * t]);

/** An arm of four nodes below what `top` is, its joints in any order. */
function arm(top, { joints = [3, 1, 4, 2], sets = 1, bindsOf = (nodes) => binds(nodes, joints) } = {}) {
  const file = new File(),
    nodes = [
      { name: "top", children: [1, 5], ...top },
      { name: "hips", children: [2], translation: [0, 1, 0.25], rotation: unit([0.1, 0.2, 0, 1]) },
      { name: "knee", children: [3], translation: [0.1, 0.5, 0] },
      { name: "foot", children: [4], translation: [0, 0.5, 0.2], rotation: unit([0, 0, 1, 3]) },
      { name: "toe", translation: [0, 0, 0.25] },
      { name: "body", mesh: 0, skin: 0 },
    ];
  Object.assign(file.json, {
    nodes,
    scenes: [{ nodes: [0] }],
    scene: 0,
    skins: [{ joints, inverseBindMatrices: file.accessor("MAT4", bindsOf(nodes)) }],
    meshes: [{ primitives: [triangles(file, joints.length, sets)] }],
  });
  return file;
}
const KEYS = Array.from({ length: 31 }, (_, i) => i / RATE);
const walk = (file, size = 1) =>
  animation(file, "walk", [
    [1, "rotation", KEYS, turns(KEYS, 0, 0.3)],
    [1, "translation", KEYS, steps(KEYS, size)],
    // Every other key has the other sign, which is the same rotation.
    [2, "rotation", KEYS, turns(KEYS, 1, 0.3).map((q, i) => q.map((x) => (i % 2 ? -x : x)))],
    [3, "rotation", [0, 1], [turns([0], 2, 0.1)[0], turns([1], 2, 0.1)[0].map((x) => -x)]],
  ]);

async function opened(bytes) {
  const gltf = await new GLTFLoader().parseAsync(bytes, ""),
    meshes = [];
  gltf.scene.traverse((object) => {
    if (object.isSkinnedMesh) meshes.push(object);
  });
  return { ...gltf, meshes };
}
/** Palettes of three.js at a time of a clip. */
function threePalette({ scene, animations, meshes }, skin, clip, time) {
  const mixer = new three.AnimationMixer(scene);
  if (clip >= 0) mixer.clipAction(animations[clip]).setLoop(three.LoopOnce).play().clampWhenFinished = true;
  mixer.setTime(time);
  scene.updateMatrixWorld(true);
  const { skeleton } = meshes[skin];
  skeleton.update();
  const palette = skeleton.boneMatrices.slice(0, 16 * skeleton.bones.length);
  mixer.stopAllAction();
  return palette;
}
/** Palettes of dq8 in the order of the joints of the skin, of a mesh as large as the file has it. */
function palette({ parents, clips, skins }, skin, clip, time) {
  const skeleton = dq8.skeleton(parents),
    joints = parents.length,
    { keys, rate } = clips[clip],
    { inverseBinds, joints: order, scale } = skins[skin];
  const made = dq8.floats(16 * joints),
    own = skeleton.clip(keys, { rate });
  skeleton.palette(own.sample(dq8.floats([time])), { inverseBinds: dq8.motions(inverseBinds), palette: made });
  return Array.from(order).flatMap((joint) =>
    Array.from(made.view.subarray(16 * joint, 16 * joint + 16), (x, i) => (i < 12 ? scale * x : x)),
  );
}
/** The largest difference of palettes at all frames, and between them. */
async function compared(bytes, { options = {}, bound = BOUND, times = 45, largest = 1 } = {}) {
  const file = await opened(bytes),
    read = readGltf(bytes, { rate: RATE, ...options });
  let worst = 0;
  read.clips.forEach((clip, c) =>
    read.skins.forEach((_, s) => {
      const same = readThree(file.meshes[s].skeleton, file.animations, { rate: RATE, ...options });
      for (let i = 0; i <= times; i++) {
        const time = (clip.duration * i) / times,
          wanted = threePalette(file, s, c, time);
        for (const [from, found] of [
          ["glTF", palette(read, s, c, time)],
          ["three.js", palette(same, 0, c, time)],
        ]) {
          found.forEach((x, k) => {
            worst = Math.max(worst, Math.abs(x - wanted[k]));
            assert.ok(
              Math.abs(x - wanted[k]) <= bound * largest,
              `${from}, ${clip.name} at ${time}: [${k}] is ${x}, three.js has ${wanted[k]}`,
            );
          });
        }
      }
    }),
  );
  return { read, worst };
}

const channels = (file, ...all) => animation(file, "", all);
const fails = (run, text) =>
  assert.throws(run, (error) => {
    assert.match(error.message, text);
    return true;
  });
const quarter = new three.Matrix4()
  .compose(new three.Vector3(1, 2, 3), new three.Quaternion(...unit([1, 0, 2, 3])), new three.Vector3(0.5, 0.5, 0.5))
  .toArray();

describe("palettes are those of three.js", () => {
  test("of an armature with the scale 0.01, its joints in any order", async (t) => {
    const file = arm({ scale: [0.01, 0.01, 0.01], rotation: unit([1, 0, 0, 1]) });
    const { read, worst } = await compared(file.bytes({ animations: [walk(file, 100)] }));
    t.diagnostic(`${worst}`);
    assert.deepEqual(read.names, ["hips", "knee", "foot", "toe"], "the armature is folded");
    assert.deepEqual([...read.parents], [-1, 0, 1, 2]);
    assert.deepEqual([...read.skins[0].joints], [2, 0, 3, 1]);
    assert.equal(read.skins[0].scale, 1);
    assert.deepEqual(read.left, []);
    assert.ok(read.clips[0].error.rotation < 1e-3, "keys of either sign are near each other");
  });

  test("of a matrix on a node above the joints, and of a mesh of another size than its joints", async () => {
    const file = arm({ matrix: quarter });
    await compared(file.bytes({ animations: [walk(file)] }));
    // Inverse binds that do not know of the scale: the mesh becomes half as large.
    const other = arm(
      { scale: [0.5, 0.5, 0.5] },
      {
        bindsOf: (nodes) =>
          binds(
            nodes.map(({ scale, ...node }) => node),
            [3, 1, 4, 2],
          ),
      },
    );
    const { read } = await compared(other.bytes({ animations: [walk(other)] }));
    assert.ok(Math.abs(read.skins[0].scale - 0.5) < 1e-7);
    read.skins[0].primitives[0].positions.forEach((x, i) => assert.ok(Math.abs(x - Math.sin(i) / 2) < 1e-7));
  });

  test("of mirrored joints, a scale in the middle, a few joints, and nodes above that move", async () => {
    const middle = arm({ scale: [-1, -1, -1] }, { joints: [4, 2] });
    middle.json.nodes[2].scale = [3, 3, 3];
    middle.json.skins[0].inverseBindMatrices = middle.accessor("MAT4", binds(middle.json.nodes, [4, 2]));
    const animations = [
      walk(middle),
      channels(middle, [0, "rotation", KEYS, turns(KEYS, 2, 0.2)], [3, "scale", [0, 1], [1, 1, 1, 1, 1.000001, 1]]),
    ];
    const { read } = await compared(middle.bytes({ animations }), { largest: 6 });
    assert.deepEqual(read.names, ["top", "hips", "knee", "foot", "toe"], "what some clip moves is a joint");
    assert.deepEqual([...read.skins[0].joints], [4, 2]);
  });

  test("of a mirrored skin, whose normals still look out of its triangles", () => {
    const file = new File(),
      corners = [0, 0, 0, 2, 0, 0, 0, 3, 0];
    const attributes = {
      POSITION: file.accessor("VEC3", corners),
      NORMAL: file.accessor("VEC3", [0, 0, 1, 0, 0, 1, 0, 0, 1]),
      JOINTS_0: file.accessor("VEC4", new Uint8Array(12)),
      WEIGHTS_0: file.accessor("VEC4", [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]),
    };
    for (const scale of [1, -1]) {
      const nodes = [{ scale: [scale, scale, scale], children: [1] }, {}, { mesh: 0, skin: 0 }];
      const read = readGltf(
        file.bytes({ nodes, meshes: [{ primitives: [{ attributes }] }], skins: [{ joints: [1] }] }),
      );
      const [{ scale: found, primitives }] = read.skins,
        [{ positions, normals, indices }] = primitives;
      assert.equal(found, scale);
      const [a, b, c] = Array.from(indices, (i) => positions.subarray(3 * i, 3 * i + 3)),
        [u, v] = [b, c].map((to) => to.map((x, k) => x - a[k]));
      const out = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
      assert.deepEqual([...positions].map(Math.abs), corners);
      assert.deepEqual([positions[3], normals[2], out[2]], [2 * scale, scale, 6 * scale]);
    }
  });

  test("of cubic splines", async () => {
    const file = arm({}),
      times = [0, 0.4, 1],
      key = (q) => [[0.1, 0, 0.2, 0], q, [0, 0.3, 0, -0.1]];
    const rotations = turns(times, 1, 0.5).flatMap(key),
      moves = steps(times, 1).flatMap((t) => [[0.5, 0, 0], t, [0, 0, -1]]);
    const animations = [
      channels(
        file,
        [1, "rotation", times, rotations, "CUBICSPLINE"],
        [1, "translation", times, moves, "CUBICSPLINE"],
        [2, "rotation", times, rotations, "CUBICSPLINE"],
      ),
    ];
    const { read } = await compared(file.bytes({ animations }), { options: { rate: 960 } });
    const { error } = read.clips[0];
    assert.ok(error.rotation > 0 && error.rotation < 1e-5 && error.translation < 5e-6, JSON.stringify(error));
  });

  test("of steps, at frames", async () => {
    const file = arm({}),
      times = [0, 0.125, 0.5, 1];
    const animations = [
      channels(
        file,
        [1, "rotation", times, turns(times, 0, 1), "STEP"],
        [2, "translation", times, steps(times, 1), "STEP"],
      ),
    ];
    const { read } = await compared(file.bytes({ animations }), { options: { rate: 32 }, times: 32 });
    assert.ok(read.clips[0].error.rotation > 0.1, "between frames a step takes a frame, and the error says so");
  });

  test("of bones that are turned round any axis", async () => {
    for (const q of [
      [1, 0.1, 0.2, 0.05],
      [0.2, 1, 0.1, -0.1],
      [0.1, -0.2, 1, 0.1],
      [0.3, 0.2, -0.1, 1],
    ]) {
      const file = arm({ rotation: unit(q) });
      await compared(file.bytes({ animations: [walk(file)] }), { times: 3 });
    }
  });

  test("of two animations, and those that are chosen", async () => {
    const file = arm({}),
      animations = [
        walk(file),
        { ...channels(file, [3, "rotation", [0, 0.355, 0.71], turns([0, 0.355, 0.71], 1, 0.1)]), name: "kick" },
      ];
    const { read } = await compared(file.bytes({ animations }));
    assert.deepEqual(
      read.clips.map(({ name, frames }) => [name, frames]),
      [
        ["walk", 31],
        ["kick", 23],
      ],
    );
    assert.ok(Math.abs(read.clips[1].duration - 0.71) < 1e-6 && read.clips[1].rate >= RATE, "a frame lies on the end");
    const [only] = readGltf(file.bytes({ animations }), { animations: ["kick"] }).clips;
    assert.deepEqual(only.keys, read.clips[1].keys);
    fails(() => readGltf(file.bytes({ animations }), { animations: ["run"] }), /^animations: there is no run$/);
  });

  test("of two skins on one skeleton", async () => {
    const file = arm({}),
      other = [2, 1];
    file.json.skins.push({
      joints: other,
      inverseBindMatrices: file.accessor(
        "MAT4",
        binds(file.json.nodes, other).map((x, i) => (i % 16 === 12 ? x + 0.5 : x)),
      ),
    });
    file.json.meshes.push({ primitives: [triangles(file, 2)] });
    file.json.nodes.push({ name: "hat", mesh: 1, skin: 1 });
    file.json.nodes[0].children.push(6);
    const { read } = await compared(file.bytes({ animations: [walk(file)] }));
    assert.deepEqual(
      read.skins.map(({ joints }) => [...joints]),
      [
        [2, 0, 3, 1],
        [1, 0],
      ],
    );
    assert.deepEqual(
      read.skins.map(({ primitives }) => primitives.length),
      [1, 1],
    );
  });

  test("of sparse accessors, and of integers", async () => {
    const file = arm({}),
      bytes = (rows) => Int16Array.from(rows.flat(), (x) => Math.round(x * 32767));
    const spread = file.sparse("VEC3", 31, [3, 20], [0, 1, 2, 3, 0, 0.5]),
      small = turns(KEYS, 1, 0.3);
    const animations = [
      animation(file, "", [
        [1, "translation", KEYS, spread],
        [2, "rotation", KEYS, file.accessor("VEC4", bytes(small), { normalized: true })],
      ]),
    ];
    await compared(file.bytes({ animations }));
  });
});

describe("what is read", () => {
  test("the error is the largest difference, as close as four times a frame tell", async () => {
    const file = arm({}),
      times = [0, 0.17, 0.3, 1],
      read = (rate) => readGltf(file.bytes({ animations }), { rate }).clips[0];
    const animations = [
      channels(file, [1, "rotation", times, turns(times, 0, 2)], [2, "translation", times, steps(times, 1)]),
    ];
    const { rate, frames, keys, error } = read(7),
      exact = read(7 * 64);
    const worst = { rotation: 0, translation: 0 };
    for (let f = 0; f < exact.frames; f++) {
      const part = f / 64,
        a = 28 * Math.min(Math.floor(part), frames - 2),
        t = part - a / 28;
      const mix = (joint, from, count) =>
        Array.from(
          { length: count },
          (_, k) => (1 - t) * keys[a + 7 * joint + from + k] + t * keys[a + 28 + 7 * joint + from + k],
        );
      const wanted = (joint, from, count) =>
        exact.keys.subarray(28 * f + 7 * joint + from, 28 * f + 7 * joint + from + count);
      const [q, p] = [unit(mix(0, 0, 4)), wanted(0, 0, 4)],
        other = wanted(1, 4, 3);
      worst.rotation = Math.max(
        worst.rotation,
        4 * Math.asin(Math.min(Math.hypot(...q.map((x, k) => x - p[k])), Math.hypot(...q.map((x, k) => x + p[k]))) / 2),
      );
      worst.translation = Math.max(worst.translation, Math.hypot(...mix(1, 4, 3).map((x, k) => x - other[k])));
    }
    assert.equal(rate, 7);
    assert.deepEqual([error.rotationAt.joint, error.translationAt.joint], [0, 1]);
    assert.ok([error.rotationAt, error.translationAt].every(({ time }) => time > 0 && time < 1));
    for (const name of ["rotation", "translation"]) {
      assert.ok(
        worst[name] > 0.01 && error[name] >= 0.99 * worst[name] && error[name] <= 1.1 * worst[name],
        `${name}: ${error[name]} for ${worst[name]}`,
      );
    }
  });

  test("without the error the frames are the same, and the error is no number", () => {
    const file = arm({}),
      times = [0, 0.17, 0.3, 1],
      animations = [channels(file, [1, "rotation", times, turns(times, 0, 2)])],
      read = (options) => readGltf(file.bytes({ animations }), options).clips[0],
      [measured, quick] = [read({}), read({ error: false })];
    assert.deepEqual(quick.keys, measured.keys);
    assert.ok(measured.error.rotation > 0);
    assert.deepEqual(quick.error, {
      rotation: NaN,
      translation: NaN,
      rotationAt: undefined,
      translationAt: undefined,
    });
  });

  test("a step is taken at the frame of its time, though times are rounded", async () => {
    const file = arm({}),
      times = Array.from({ length: 11 }, (_, i) => i / 10),
      values = turns(times, 0, 1),
      moves = steps(times, 1);
    const animations = [
        channels(file, [1, "rotation", times, values, "STEP"], [1, "translation", times, moves, "STEP"]),
      ],
      bytes = file.bytes({ animations });
    const { meshes, animations: clips } = await opened(bytes);
    for (const {
      clips: [{ keys }],
    } of [readGltf(bytes), readThree(meshes[0].skeleton, clips)])
      times.forEach((_, i) => {
        [...values[i], ...moves[i]].forEach((x, k) =>
          assert.ok(Math.abs(keys[28 * 3 * i + k] - x) < 1e-6, `step ${i}`),
        );
      });
  });

  test("numbers that lie apart, and the smallest integer", () => {
    const file = arm({}),
      [
        {
          primitives: [{ attributes }],
        },
      ] = file.json.meshes,
      rows = Array.from({ length: 48 }, (_, i) => (i % 4 === 3 ? 99 : i % 4 ? 100 * i : -32768));
    attributes.POSITION = file.accessor("VEC3", Int16Array.from(rows), { normalized: true, count: 12 });
    file.json.bufferViews.at(-1).byteStride = 8;
    const [{ positions }] = readGltf(file.bytes()).skins[0].primitives;
    positions.forEach((x, i) =>
      assert.ok(Math.abs(x - (i % 3 ? (100 * (4 * Math.floor(i / 3) + (i % 3))) / 32767 : -1)) < 1e-7, `${i}: ${x}`),
    );
  });

  test("eight joints of a vertex, several primitives, and weights that sum to one", () => {
    const file = arm({}, { sets: 2 }),
      [{ primitives }] = file.json.meshes,
      joints = [3, 1, 4, 2];
    primitives.push(
      { ...triangles(file, 4), indices: file.accessor("SCALAR", Uint16Array.of(2, 1, 0)), targets: [{}] },
      { attributes: { POSITION: 0 } },
    );
    primitives[0].attributes.NORMAL = file.accessor(
      "VEC3",
      Array.from({ length: 36 }, (_, i) => +(i % 3 === 0)),
    );
    const read = readGltf(file.bytes()),
      {
        primitives: [a, b],
        joints: order,
      } = read.skins[0];
    assert.deepEqual(
      [a.influences, b.influences, b.normals, [...b.indices], a.indices.length],
      [8, 4, undefined, [2, 1, 0], 12],
    );
    assert.deepEqual(
      [...a.joints.subarray(0, 8)],
      [0, 1, 2, 3, 3, 0, 1, 2].map((joint) => order[joint]),
    );
    assert.deepEqual(
      [...a.joints.subarray(0, 4)].map((joint) => read.names[joint]),
      joints.map((node) => file.json.nodes[node].name),
    );
    for (const { influences, weights } of [a, b])
      for (let v = 0; v < 12; v++) {
        assert.ok(
          Math.abs(weights.subarray(influences * v, influences * (v + 1)).reduce((sum, w) => sum + w, 0) - 1) < 1e-6,
        );
      }
    assert.deepEqual(read.left, ["morph targets", "parts of a mesh without joints"]);
    assert.deepEqual(readGltf(file.bytes(), { meshes: false }).skins[0].primitives, []);
    const skin = dq8.skin({ jointCount: 4, ...a }),
      posed = dq8.floats(36);
    skin.pose({ motions: dq8.motions(4), rest: dq8.floats(a.positions), posed });
    posed.view.forEach((x, i) => assert.ok(Math.abs(x - Math.sin(i)) < 1e-6));
  });

  test("JSON with its buffers, given or in the text", () => {
    const file = arm({ scale: [2, 2, 2] }),
      bytes = file.bytes({ animations: [walk(file)] }),
      wanted = readGltf(bytes);
    const json = { ...file.json, animations: [walk(file)], buffers: [{ byteLength: file.binary().length }] };
    const uri = `data:application/octet-stream;base64,${Buffer.from(file.binary()).toString("base64")}`;
    assert.deepEqual(readGltf({ json, buffers: [file.binary()] }), wanted);
    assert.deepEqual(readGltf({ json: { ...json, buffers: [{ uri }] } }), wanted);
    assert.deepEqual(
      readGltf(new Uint8Array([9, ...new Uint8Array(bytes)]).subarray(1)),
      wanted,
      "a view that begins anywhere",
    );
    fails(
      () => readGltf({ json: { ...json, buffers: [{ uri: "walk.bin" }] } }),
      /^buffers\[0\]: walk.bin must be given/,
    );
  });

  test("ten minutes of sixty joints in a time that a page waits for", (t) => {
    const file = new File(),
      nodes = Array.from({ length: 60 }, (_, i) => (i < 59 ? { children: [i + 1] } : {})),
      times = Array.from({ length: 18001 }, (_, i) => i / RATE);
    const input = file.accessor("SCALAR", times),
      output = file.accessor("VEC4", turns(times, 0, 1).flat());
    const animations = [
      {
        channels: nodes.map((_, node) => ({ target: { node, path: "rotation" }, sampler: 0 })),
        samplers: [{ input, output }],
      },
    ];
    const bytes = file.bytes({ nodes, animations, skins: [{ joints: nodes.map((_, i) => i) }] }),
      start = process.cpuUsage();
    const { frames } = readGltf(bytes).clips[0],
      { user, system } = process.cpuUsage(start);
    assert.equal(frames, 18001);
    t.diagnostic(`${Math.round((user + system) / 1000)} ms`);
    assert.ok(user + system < 8e6, `${user + system} µs`);
  });
});

describe("what three.js has is read by its fields", () => {
  const bones = () => {
    const [root, hips, knee] = [new three.Group(), new three.Bone(), new three.Bone()];
    root.position.set(5, 0, 0);
    hips.name = "hips";
    hips.quaternion.set(...unit([1, 2, 0, 3]));
    knee.name = "knee";
    hips.position.set(0, 1, 0);
    knee.position.set(0, 0.5, 0.1);
    root.add(hips);
    hips.add(knee);
    root.updateMatrixWorld(true);
    return { root, hips, knee, skeleton: new three.Skeleton([knee, hips]) };
  };
  test("a bind matrix, a root, matrices of their own, and tracks by name, by uuid and by bone", () => {
    const { root, hips, knee, skeleton } = bones(),
      bindMatrix = new three.Matrix4().makeTranslation(0, 0, 2);
    const tracks = [
      new three.QuaternionKeyframeTrack(".bones[hips].quaternion", KEYS, turns(KEYS, 0, 0.3).flat()),
      new three.VectorKeyframeTrack(`${knee.uuid}.position`, KEYS, steps(KEYS, 1).flat()),
      new three.NumberKeyframeTrack("lamp.intensity", [0, 1], [0, 1]),
    ];
    const read = readThree(skeleton, [new three.AnimationClip("bow", 1, tracks)], { root, bindMatrix });
    assert.deepEqual(
      [read.names, [...read.parents], [...read.skins[0].joints], read.left],
      [["hips", "knee"], [-1, 0], [1, 0], ["what moves no joint"]],
    );
    assert.equal(read.rest[4], 0, "the root is left out");
    assert.equal(readThree(skeleton, []).rest[4], 5);
    const found = palette(read, 0, 0, 0.5);
    hips.quaternion.fromArray(tracks[0].createInterpolant().evaluate(0.5));
    knee.position.fromArray(tracks[1].createInterpolant().evaluate(0.5));
    root.position.set(0, 0, 0);
    hips.updateMatrix();
    hips.matrixAutoUpdate = false;
    hips.position.set(9, 9, 9);
    root.updateMatrixWorld(true);
    const wanted = [knee, hips].flatMap((bone, k) =>
      bone.matrixWorld.clone().multiply(skeleton.boneInverses[k]).multiply(bindMatrix).toArray(),
    );
    found.forEach((x, i) => assert.ok(Math.abs(x - wanted[i]) < BOUND));
    assert.ok(Math.abs(readThree(skeleton, []).rest[5] - 1) < 1e-6, "a matrix of its own");
  });
  test("a part of a rotation is refused by name", () => {
    const clip = new three.AnimationClip("nod", 1, [new three.NumberKeyframeTrack("hips.rotation[x]", [0, 1], [0, 1])]);
    fails(
      () => readThree(bones().skeleton, [clip]),
      /^clips\[0\] \(nod\): hips.rotation\[x\] moves a part of rotation/,
    );
    const { hips, skeleton } = bones();
    hips.scale.set(1, 2, 1);
    fails(() => readThree(skeleton, []), /^bones\[1\] \(hips\): scale is 1, 2, 1: only a uniform scale/);
  });
});

describe("what cannot be is an error that names it, with node and path", () => {
  const wrong = (text, change, options) => {
    const file = arm({}),
      json = { animations: [walk(file)], ...change(file, file.json) };
    fails(() => readGltf(file.bytes(json), options), text);
  };
  test("scales", () => {
    wrong(
      /^animations\[0\] \(walk\): scale of nodes\[2\] \(knee\) is 1.5, 1.5, 1.5 at 0.25 s, and 1 at rest/,
      (file) => ({ animations: [{ ...channels(file, [2, "scale", [0, 1], [1, 1, 1, 3, 3, 3]]), name: "walk" }] }),
    );
    wrong(/^animations\[0\]: scale of nodes\[1\] \(hips\) is 1.0625, 1, 1 at 0.25 s/, (file) => ({
      animations: [
        channels(file, [1, "scale", [0, 1], [0, 0, 0, 1, 1, 1, 4 / 9, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0], "CUBICSPLINE"]),
      ],
    }));
    wrong(/^nodes\[2\] \(knee\): scale is 1, 1, 1.1: only a uniform scale/, (_, { nodes }) => {
      nodes[2].scale = [1, 1, 1.1];
    });
    wrong(/^nodes\[2\] \(knee\): scale is 0, 0, 0: only a uniform scale/, (_, { nodes }) => {
      nodes[2].scale = [0, 0, 0];
    });
    wrong(/^nodes\[0\] \(top\).matrix: shears: its axes are not perpendicular/, (_, { nodes }) => {
      nodes[0].matrix = [1, 0, 0, 0, 0.6, 0.8, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
    });
    wrong(/^nodes\[0\] \(top\).matrix: scales its axes by 2, 1, 1, which is not uniform/, (_, { nodes }) => {
      nodes[0].matrix = [2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
    });
    wrong(
      /Matrices\[1\], of nodes\[1\] \(hips\): makes the mesh 0.5 times as large, and the first joint 1 times/,
      (file, { skins: [skin] }) => {
        skin.inverseBindMatrices = file.accessor(
          "MAT4",
          Array.from({ length: 64 }, (_, i) => ((i % 5) - ((i >> 4) % 5) ? 0 : i)).map((_, i) =>
            (i % 16) % 5 ? 0 : i >> 4 === 1 && i % 16 < 15 ? 0.5 : 1,
          ),
        );
      },
    );
  });
  test("compression", () => {
    const draco = (_, { meshes }) => {
      meshes[0].primitives[0].extensions = { KHR_draco_mesh_compression: {} };
      return { extensionsRequired: ["KHR_draco_mesh_compression"] };
    };
    wrong(
      /^nodes\[5\] \(body\): meshes\[0\].primitives\[0\]: is compressed by KHR_draco_mesh_compression: decode/,
      draco,
    );
    const file = arm({});
    assert.equal(readGltf(file.bytes(draco(file, file.json)), { meshes: false }).names.length, 4);
    wrong(/^accessors\[0\]: bufferViews\[0\] is compressed by EXT_meshopt_compression/, (_, { bufferViews }) => {
      bufferViews[0].extensions = { EXT_meshopt_compression: {} };
    });
    wrong(/^extensionsRequired: ACME_bones is not known here$/, () => ({
      extensionsRequired: ["KHR_materials_unlit", "ACME_bones"],
    }));
  });
  test("numbers and places that are not there", () => {
    const set = (change) => (file, json) => change(json, file);
    wrong(/^skins: there is none/, () => ({ skins: [] }));
    wrong(
      /^skins\[0\]: there is no node 77$/,
      set(({ skins: [skin] }) => {
        skin.joints[1] = 77;
      }),
    );
    wrong(
      /^nodes\[\d\] \(.*\): is its own ancestor$/,
      set(({ nodes }) => {
        nodes[4].children = [1];
      }),
    );
    wrong(
      /^accessors\[0\]: its numbers lie beyond the file$/,
      set(({ bufferViews }) => {
        bufferViews[0].byteLength = 8;
      }),
    );
    wrong(
      /^accessors\[0\]: type is VEC4, and skins\[0\] has MAT4$/,
      set(({ accessors }) => {
        accessors[0].type = "VEC4";
      }),
    );
    wrong(
      /^skins\[0\]: has 3 inverse binds for 4 joints$/,
      set(({ accessors }) => {
        accessors[0].count = 3;
      }),
    );
    wrong(
      /vertex 0 has the joint 9 of 4$/,
      set(
        (
          {
            meshes: [
              {
                primitives: [{ attributes }],
              },
            ],
          },
          file,
        ) => {
          attributes.JOINTS_0 = file.accessor("VEC4", new Uint8Array(48).fill(9));
        },
      ),
    );
    wrong(
      /^animations\[0\].channels\[0\]: has 4 numbers for 2 keys, which need 8$/,
      set((_, file) => ({ animations: [channels(file, [1, "rotation", [0, 1], [0, 0, 0, 1]])] })),
    );
    wrong(
      /^animations\[0\].channels\[0\]: time 1 is 0.5 after 1$/,
      set((_, file) => ({ animations: [channels(file, [1, "translation", [1, 0.5], [0, 0, 0, 1, 0, 0]])] })),
    );
    wrong(
      /^animations\[0\]: nodes\[1\] \(hips\) at 0 s: rotation is 0,0,0,0, which is none$/,
      set((_, file) => ({ animations: [channels(file, [1, "rotation", [0, 1], new Array(8).fill(0)])] })),
    );
    wrong(
      /^animations\[0\]: 1000000000 s of 4 joints at 30 frames a second are more than memory holds$/,
      set((_, file) => ({ animations: [channels(file, [1, "translation", [0, 1e9], new Array(6).fill(0)])] })),
    );
    wrong(/^rate is 0, not a positive number$/, () => ({}), { rate: 0 });
    fails(() => readGltf(new Uint8Array(40)), /^byte 0: this is no .glb$/);
  });
});
