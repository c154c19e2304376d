// Compiled by `bundlers`, never run: what the declarations allow, and what they refuse.
import load, { Clip, LevelError, Sampled, Skeleton, compile, load as named, supports } from "dq8";
import { Floats } from "dq8";
import relaxed from "dq8/relaxed";
import { fromMatrices, readGlb, readGltf, readThree } from "dq8/gltf";
import loadRobots, { Robot } from "dq8/robots";
import robotsRelaxed from "dq8/robots-relaxed";
import loadPacker, { PackError } from "dq8/pack";

const dq8 = await load({ level: relaxed, fallback: supports("relaxed") });
await named({ wasm: new Uint8Array(8) });
await loadRobots({ level: robotsRelaxed });
await named({ wasm: await compile() });
// @ts-expect-error: the text of an address is neither bytes nor a module.
await named({ wasm: "dq8.simd128.wasm" });
// @ts-expect-error: levels are of one module.
await load({ level: robotsRelaxed });
// @ts-expect-error: a level that has to be imported.
await load({ level: "relaxed" });
const lacking: "simd128" | "relaxed" | undefined = await compile().then(
  () => undefined,
  (error: unknown) => (error instanceof LevelError ? error.level : undefined),
);
const skeleton: Skeleton = dq8.skeleton([-1, 0]);
const locals: Floats = dq8.motions(2);
const palette = dq8.floats(32),
  inverseBinds = dq8.motions(2),
  at = dq8.floats(1);
const walk = skeleton.clip(new Float32Array(28)).sample(at);
skeleton.localToModel(locals);
skeleton.palette(walk.blend(walk, at), { inverseBinds, palette });
skeleton.palette(walk.blend(dq8.poses(locals), 0.5, { law: "slerp" }).add(walk, at), { inverseBinds, palette });
// @ts-expect-error: there is no such law.
walk.blend(walk, at, { law: "lerp" });
const packed = dq8.packedClip(new ArrayBuffer(8)),
  run = packed.sample(at, packed.clips - 1);
skeleton.localToModel(run.blend(packed.sample(at, at), at), palette);
// @ts-expect-error: which of the clips is a number, or one for each instance.
packed.sample(at, "walk");
const bytes: Float32Array = palette.view;
// @ts-expect-error: sampled clips have no memory to go to.
skeleton.localToModel(walk);
// @ts-expect-error: palettes need inverse binds.
skeleton.palette(locals, { palette });
// @ts-expect-error: there is no such level.
await load({ level: "avx2" });
const {
  parents,
  clips: [bow],
  skins: [
    {
      inverseBinds: inverses,
      primitives: [part],
    },
  ],
} = readGltf(readGlb(new ArrayBuffer(8)), { rate: 60, skins: ["body", 0] });
const posed = dq8.skeleton(parents).clip(bow!.keys, bow!),
  limb = dq8.skin({ jointCount: parents.length, ...part! }),
  moved = dq8.motions(inverses.length ? inverses : fromMatrices([]));
// @ts-expect-error: meshes of three.js stay there.
readThree({ bones: [], boneInverses: [] }).skins[0].primitives;
const packer = await loadPacker();
const library = dq8.packedClip(packer.pack(parents.length, [{ ...bow!, loops: true }], { angle: 1e-4 }));
const place: number | undefined = new Error() instanceof PackError ? library.clips : undefined;
// @ts-expect-error: packing has one level.
await loadPacker({ level: relaxed });
// @ts-expect-error: one clip is an array of one.
packer.pack(1, bow!);
const robot = (await loadRobots()).robot("<robot/>");
const { outcome } = robot.reach(1, locals, at, { position: true });
const arm = (await loadRobots()).robot("<robot/>", { base: at, tools: [{ name: "tip", link: "hand", pose: at }] });
const [report] = arm.follow("tip", locals, at),
  {
    found: [nearest],
  } = arm.solutions("tip", locals, at);
const angles: Float32Array | undefined = nearest?.values,
  again: number | undefined = report?.restarts;
// @ts-expect-error: what follows never begins elsewhere.
arm.follow("tip", locals, at, { restarts: true });
// @ts-expect-error: skeletons are made of parents by a module.
new Skeleton([-1]);
/** What is declared can be told apart when it runs. */
function kind(noun: unknown): string {
  if (noun instanceof Floats) return String(noun.view.length);
  if (noun instanceof Clip) return String(noun.frames);
  if (noun instanceof Robot) return noun.linkNames.join();
  return noun instanceof Sampled ? "poses" : "";
}
const known: "converged" | "outOfReach" | "atLimits" | "stalled" | "unfinished" | "invalid" = outcome;
palette[Symbol.dispose]();
export { again, angles, bytes, kind, known, lacking, limb, moved, place, posed };
