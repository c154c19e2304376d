import { Scene, colour, place, rgb } from "./scene.js";

export function yours(dq8, section) {
  const state = { show };
  let scene, made;
  /** Throws before anything has changed. */
  function show(name, { parents, keys, seconds, mesh, what }) {
    const joints = parents.length, next = { own: [], parents, seconds, frames: keys.length / 7 / joints, indices: mesh?.indices }, keep = (thing) => (next.own.push(thing), thing);
    try {
      next.skeleton = keep(dq8.skeleton(parents)); next.clip = keep(next.skeleton.clip(keys)); next.at = keep(dq8.floats(1)); next.models = keep(dq8.motions(joints));
      next.skeleton.localToModel(next.clip.sample(next.at), next.models);
      if (next.models.view.some((x) => !Number.isFinite(x))) throw new Error("a number in it is not finite");
      if (mesh) {
        next.binds = keep(dq8.motions(mesh.inverseBinds)); next.motions = keep(dq8.motions(joints));
        next.skin = keep(dq8.skin({ jointCount: joints, influences: mesh.influences, joints: mesh.joints, weights: mesh.weights })); next.rest = keep(dq8.floats(mesh.rest)); next.posed = keep(dq8.floats(mesh.rest.length));
      }
    } catch (error) { for (const thing of next.own) thing.free(); throw error; }
    for (const thing of made?.own ?? []) thing.free();
    made = next;
    section.hidden = false;
    section.querySelector("h2").textContent = name;
    scene ??= new Scene(section, { yaw: 0.4, pitch: 0.15 });
    pose(0);
    const points = mesh ? Array.from({ length: mesh.rest.length / 3 }, (_, i) => made.posed.view.subarray(3 * i, 3 * i + 3)) : parents.map((_, j) => place(made.models.view, j));
    const ends = [0, 1, 2].map((k) => points.reduce(([low, high], p) => [Math.min(low, p[k]), Math.max(high, p[k])], [Infinity, -Infinity]));
    scene.centre = ends.map(([low, high]) => (low + high) / 2);
    scene.size = 1.5 * Math.max(1e-3, ...ends.map(([low, high]) => high - low));
    scene.output.textContent = what;
    Object.assign(state, { name, joints, frames: next.frames });
    scene.draw = draw;
    draw();
    section.scrollIntoView();
    return what;
  }
  function pose(frame) {
    const { skeleton, clip, at, models, skin } = made;
    at.view[0] = frame;
    skeleton.localToModel(clip.sample(at), models);
    if (skin) { dq8.mul(models, made.binds, made.motions); skin.pose({ motions: made.motions, rest: made.rest, posed: made.posed }); }
  }
  function draw() {
    const { models, posed, parents, indices } = made, project = scene.project();
    scene.clear();
    if (posed) return scene.triangles(posed.view, indices, rgb("--b"), project);
    // It may walk away: the first joint stays in the middle.
    const root = place(models.view, 0), at = parents.map((_, j) => { const [x, y, z] = place(models.view, j); return project(x - root[0] + scene.centre[0], y, z - root[2] + scene.centre[2]); });
    parents.forEach((parent, j) => { if (parent >= 0) scene.line([at[parent], at[j]], colour("--b"), 4); });
  }
  const loop = (now) => {
    if (made && !document.hidden) { pose((now / 1000 / made.seconds) % Math.max(1, made.frames - 1)); draw(); }
    requestAnimationFrame(loop);
  };
  requestAnimationFrame(loop);
  return state;
}
