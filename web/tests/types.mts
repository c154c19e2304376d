// Compiled by `tsc -p web`, never run: what the declarations allow, and what they refuse.
import load, { type Floats, type Skeleton } from "../package/dq8.js";
import { readGlb, readGltf, readThree } from "../package/gltf.js";
import loadRobots from "../package/robots.js";

const dq8 = await load({ level: "relaxed" });
const skeleton: Skeleton = dq8.skeleton([-1, 0]);
const locals: Floats = dq8.motions(2);
const palette = dq8.floats(32), inverseBinds = dq8.motions(2), at = dq8.floats(1);
const walk = skeleton.clip(new Float32Array(28)).sample(at);
skeleton.localToModel(locals);
skeleton.palette(walk.blend(walk, at), { inverseBinds, palette });
skeleton.palette(walk.blend(dq8.poses(locals), 0.5, { law: "slerp" }).add(walk, at), { inverseBinds, palette });
// @ts-expect-error: there is no such law.
walk.blend(walk, at, { law: "lerp" });
const packed = dq8.packedClip(new ArrayBuffer(8)), run = packed.sample(at, packed.clips - 1);
skeleton.localToModel(run.blend(packed.sample(at, at), at), palette);
// @ts-expect-error: which of the clips is a number, or one for each instance.
packed.sample(at, "walk");
const bytes: Float32Array<ArrayBuffer> = palette.view;
// @ts-expect-error: sampled clips have no memory to go to.
skeleton.localToModel(walk);
// @ts-expect-error: palettes need inverse binds.
skeleton.palette(locals, { palette });
// @ts-expect-error: there is no such level.
await load({ level: "avx2" });
const { parents, clips: [bow], skins: [{ inverseBinds: inverses, primitives: [part] }] } = readGltf(readGlb(new ArrayBuffer(8)), { rate: 60, skins: ["body", 0] });
const posed = dq8.skeleton(parents).clip(bow!.keys, bow!), limb = dq8.skin({ jointCount: parents.length, ...part! }), moved = dq8.motions(inverses);
// @ts-expect-error: meshes of three.js stay there.
readThree({ bones: [], boneInverses: [] }).skins[0].primitives;
const robot = (await loadRobots()).robot("<robot/>");
const { outcome } = robot.reach(1, locals, at, { position: true });
const known: "converged" | "outOfReach" | "atLimits" | "stalled" | "unfinished" | "invalid" = outcome;
export { bytes, known, limb, moved, posed };
