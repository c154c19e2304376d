// From a glTF, or from three.js, to what `dq8` takes: parents, clips, inverse binds, skinned
// meshes. gltf.d.ts has the types. Nothing here needs WebAssembly.
import { Accessors, fail, readGlb } from "./accessors.js";
import { decompose } from "./rigid.js";
import { TOLERANCE, rig } from "./rig.js";
import { Track } from "./tracks.js";

export { readGlb } from "./accessors.js";
export { fromMatrices } from "./rigid.js";
export { readThree } from "./three.js";

/** What a file may require though it changes no number that is read here, or is read. */
const HARMLESS = new RegExp(
  "^(KHR_(materials|texture|lights|xmp|animation_pointer|node_visibility)|EXT_(texture|lights)" +
    "|MSFT_(texture|lod)|KHR_mesh_quantization$)",
);
const PATHS = { rotation: "VEC4", translation: "VEC3", scale: "VEC3" };
const DRACO = "KHR_draco_mesh_compression";
const LATER = ["EXT_meshopt_compression", "KHR_meshopt_compression", DRACO];

const named = (place, { name }) => (name ? `${place} (${name})` : place);

/** All nodes with their parents; of joints and of what they hang from, a matrix in parts. */
function nodesOf({ nodes = [] }, joints, tolerance) {
  const up = new Map(),
    used = new Set();
  nodes.forEach(({ children = [] }, i) => {
    for (const child of children) up.set(child, i);
  });
  for (const joint of joints) for (let i = joint; i !== undefined && !used.has(i); i = up.get(i)) used.add(i);
  const made = nodes.map(
    ({ name = "", matrix, rotation = [0, 0, 0, 1], translation = [0, 0, 0], scale = [1, 1, 1] }, i) => {
      const node = { name, place: `nodes[${i}]`, parent: up.get(i) ?? -1, rotation, translation, scale };
      if (!matrix || !used.has(i)) return node;
      const parts = decompose(matrix, tolerance);
      if (typeof parts === "string") fail(`${named(node.place, node)}.matrix`, parts);
      return { ...node, rotation: parts.q, translation: parts.t, scale: [parts.s, parts.s, parts.s] };
    },
  );
  return { nodes: made, used };
}

/** Tracks of one animation by the node that they move; what moves no joint is left out. */
function clipOf(animation, place, accessors, used, left) {
  const tracks = new Map();
  let duration = 0;
  animation.channels.forEach(({ target: { node, path }, sampler }, c) => {
    const where = `${place}.channels[${c}]`;
    if (path === "weights") left.add("morph targets");
    else if (!PATHS[path]) left.add(`${path} of an animation`);
    else if (node === undefined || !used.has(node)) left.add("what moves no joint");
    else {
      const {
        input,
        output,
        interpolation = "LINEAR",
      } = animation.samplers[sampler] ?? fail(where, `there is no sampler ${sampler}`);
      if (!["LINEAR", "STEP", "CUBICSPLINE"].includes(interpolation)) fail(where, `interpolation is ${interpolation}`);
      const width = path === "rotation" ? 4 : 3,
        times = accessors.read(input, ["SCALAR"], where),
        values = accessors.read(output, [PATHS[path]], where);
      const needed = times.length * width * (interpolation === "CUBICSPLINE" ? 3 : 1);
      if (!times.length) fail(where, "has no key");
      if (values.length !== needed)
        fail(where, `has ${values.length} numbers for ${times.length} keys, which need ${needed}`);
      times.forEach((time, i) => {
        if (!(time >= 0 && time < Infinity && !(time < times[i - 1])))
          fail(where, `time ${i} is ${time} after ${times[i - 1] ?? 0}`);
      });
      duration = Math.max(duration, times.at(-1));
      if (!tracks.has(node)) tracks.set(node, {});
      tracks.get(node)[path] = new Track(times, values, width, interpolation);
    }
  });
  return { name: animation.name ?? "", place, duration, tracks };
}

/** Joints and weights [vertex][4 or 8], the weights of a vertex with the sum 1. */
function influences({ attributes }, accessors, joints, place) {
  const sets = attributes.JOINTS_1 === undefined ? 1 : 2,
    width = 4 * sets,
    read = (name, k) => accessors.read(attributes[`${name}_${k}`], ["VEC4"], `${place}.${name}_${k}`);
  if (attributes.JOINTS_2 !== undefined) fail(place, "has JOINTS_2: more than 8 joints for a vertex");
  const indices = Array.from({ length: sets }, (_, k) => read("JOINTS", k)),
    given = Array.from({ length: sets }, (_, k) => read("WEIGHTS", k));
  const vertices = indices[0].length / 4,
    out = { influences: width, joints: new Uint16Array(width * vertices), weights: new Float32Array(width * vertices) };
  for (const part of [...indices, ...given])
    if (part.length !== 4 * vertices) fail(place, "has joints and weights of different numbers of vertices");
  for (let v = 0; v < vertices; v++) {
    const own = Array.from({ length: width }, (_, i) => given[i >> 2][4 * v + (i & 3)]),
      sum = own.reduce((a, b) => a + b, 0);
    if (!(sum >= 0 && sum < Infinity)) fail(place, `vertex ${v} has the weights ${own}`);
    own.forEach((weight, i) => {
      const joint = indices[i >> 2][4 * v + (i & 3)],
        used = weight !== 0 || (sum === 0 && i === 0);
      if (used && joint >= joints.length) fail(place, `vertex ${v} has the joint ${joint} of ${joints.length}`);
      out.joints[width * v + i] = used ? joints[joint] : joints[0];
      out.weights[width * v + i] = sum === 0 ? +(i === 0) : weight / sum;
    });
  }
  return out;
}

/** One primitive that follows joints, as large as its skin wants it. */
function primitiveOf(primitive, place, accessors, { joints, scale }, left) {
  const { attributes, indices, targets, mode = 4 } = primitive;
  if (primitive.extensions?.[DRACO] && accessors.required(DRACO))
    fail(place, `is compressed by ${DRACO}: decode the file first, or read it with { meshes: false }`);
  if (targets) left.add("morph targets");
  const floats = (name) => Float32Array.from(accessors.read(attributes[name], ["VEC3"], `${place}.${name}`));
  const positions = floats("POSITION").map((x) => scale * x),
    made = { place, mode, positions, ...influences(primitive, accessors, joints, place) };
  if (3 * made.joints.length !== made.influences * positions.length)
    fail(place, "has joints and positions of different numbers of vertices");
  if (attributes.NORMAL !== undefined) made.normals = floats("NORMAL").map((x) => Math.sign(scale) * x);
  made.indices =
    indices === undefined
      ? Uint32Array.from({ length: positions.length / 3 }, (_, i) => i)
      : Uint32Array.from(accessors.read(indices, ["SCALAR"], `${place}.indices`));
  const beyond = made.indices.findIndex((index) => 3 * index >= positions.length);
  if (beyond >= 0) fail(`${place}.indices`, `${made.indices[beyond]} is beyond ${positions.length / 3} vertices`);
  // A mirror turns triangles inside out.
  if (scale < 0 && mode === 4)
    for (let i = 0; i + 2 < made.indices.length; i += 3) made.indices.subarray(i + 1, i + 3).reverse();
  return made;
}

/** Those of a list that are chosen by number or name, with their places; all without a choice. */
function chosen(all = [], what, choice) {
  const numbers =
    choice?.map((one) => (typeof one === "number" ? one : all.findIndex(({ name }) => name === one))) ??
    all.map((_, i) => i);
  return numbers.map((i, k) => ({
    ...(all[i] ?? fail(what, `there is no ${choice[k]}`)),
    index: i,
    place: named(`${what}[${i}]`, all[i]),
  }));
}

const IDENTITY = Array.from({ length: 16 }, (_, i) => +(i % 5 === 0));

function skinOf({ name = "", place, joints, inverseBindMatrices: given }, accessors) {
  const matrices = given === undefined ? undefined : accessors.read(given, ["MAT4"], place);
  if (matrices && matrices.length < 16 * joints.length)
    fail(place, `has ${matrices.length / 16} inverse binds for ${joints.length} joints`);
  const of = (k) => matrices?.subarray(16 * k, 16 * k + 16) ?? IDENTITY;
  return { name, place, joints, inverseBinds: { place: `${place}.inverseBindMatrices`, of } };
}

/** Skeleton, clips, skins and skinned meshes of bytes of a .glb, or of { json, buffers }. */
export function readGltf(file, options = {}) {
  const source = file?.json ? file : readGlb(file),
    { json } = source,
    accessors = new Accessors(source),
    left = new Set();
  for (const name of json.extensionsRequired ?? [])
    if (!HARMLESS.test(name) && !LATER.includes(name)) fail("extensionsRequired", `${name} is not known here`);
  const skins = chosen(json.skins, "skins", options.skins),
    animations = chosen(json.animations, "animations", options.animations);
  if (!skins.length) fail("skins", "there is none: nothing here follows joints");
  const { nodes, used } = nodesOf(
    json,
    skins.flatMap(({ joints }) => joints),
    options.tolerance ?? TOLERANCE,
  );
  const clips = animations.map((animation) => clipOf(animation, animation.place, accessors, used, left));
  const made = rig(
    nodes,
    skins.map((skin) => skinOf(skin, accessors)),
    clips,
    options,
  );
  made.skins.forEach((skin, i) => {
    skin.primitives = [];
    if (options.meshes === false) return;
    const meshes = new Map(
      nodes.flatMap((node, n) =>
        json.nodes[n].skin === skins[i].index ? [[json.nodes[n].mesh, named(node.place, node)]] : [],
      ),
    );
    for (const [number, whose] of meshes) {
      const mesh = json.meshes?.[number] ?? fail(whose, `there is no mesh ${number}`);
      mesh.primitives.forEach((primitive, k) => {
        const place = `${whose}: ${named(`meshes[${number}]`, mesh)}.primitives[${k}]`;
        if (primitive.attributes.JOINTS_0 === undefined) left.add("parts of a mesh without joints");
        else skin.primitives.push({ mesh: mesh.name ?? "", ...primitiveOf(primitive, place, accessors, skin, left) });
      });
    }
  });
  return { ...made, left: [...left] };
}
