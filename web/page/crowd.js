import { animate } from "../bench/plain.js";
import { place } from "./motion.js";
import { ENDS, FRAMES, JOINTS, LIMBS, RUN, WALK, binds, ground, parents } from "./person.js";
import { Scene } from "./scene.js";
import { Stage } from "./stage.js";

/** How many people are computed at a time: so many as the cache holds. */
const BATCH = 256,
  /** Rounds of a comparison, in which both take turns, and those before, in which engines compile JavaScript. */
  ROUNDS = 15,
  WARM = 10,
  /** How many frames the time is the median of. */
  KEPT = 31,
  /** How much lower people stand, so that a foot lower down is in reach. */
  SINK = 0.16;
const MOST = 10000,
  LOOP = FRAMES - 1;
const median = (of) => of.slice().sort((a, b) => a - b)[of.length >> 1];

/** Where each person stands, [x y z w tx ty tz]. */
function standing(people) {
  const side = Math.ceil(Math.sqrt(people)),
    roots = new Float32Array(7 * people);
  for (let i = 0; i < people; i++) {
    const x = 1.1 * ((i % side) - (side - 1) / 2) + 0.3 * Math.sin(7 * i),
      z = 1.1 * (Math.floor(i / side) - (side - 1) / 2) + 0.3 * Math.cos(5 * i);
    roots.set([0, 0, 0, 1, x, ground(x, z) - SINK, z], 7 * i);
  }
  return roots;
}

class Crowd {
  #dq8;
  #skeleton;
  #clips;
  #inverseBinds;
  #own = [];
  constructor(dq8) {
    this.#dq8 = dq8;
    this.#skeleton = dq8.skeleton(parents);
    this.#clips = [WALK, RUN].map((keys) => this.#skeleton.clip(keys));
    this.#inverseBinds = dq8.motions(JOINTS);
    this.#motions(binds, this.#inverseBinds);
  }
  #motions(given, motions) {
    const from = this.#dq8.floats(given);
    this.#dq8.fromRotationsTranslations(from, motions);
    from.free();
  }
  /** Memory for so many people: their palettes, and one batch's models. */
  resize(people) {
    for (const array of this.#own) array.free();
    this.#own = [];
    const keep = (array) => (this.#own.push(array), array),
      floats = (count) => keep(this.#dq8.floats(count)),
      scratch = new Map();
    this.people = people;
    this.roots = standing(people);
    [this.at, this.atRun, this.weights] = [0, 0, 0].map(() => new Float32Array(people));
    for (let i = 0; i < people; i++) [this.at[i], this.atRun[i]] = [(7.3 * i) % LOOP, (11.9 * i) % LOOP];
    this.pace = Float32Array.from({ length: people }, (_, i) => 0.8 + 0.4 * ((i * 0.618) % 1));
    this.heights = LIMBS.map(() => new Float32Array(people));
    this.batches = [];
    for (let first = 0; first < people; first += BATCH) {
      const count = Math.min(BATCH, people - first),
        poles = Float32Array.from({ length: 3 * count }, (_, i) => +(i % 3 === 2));
      if (!scratch.has(count)) {
        scratch.set(count, {
          models: keep(this.#dq8.motions(count * JOINTS)),
          poles: floats(poles),
          targets: LIMBS.map(() => floats(3 * count)),
          inputs: [0, 0, 0].map(() => floats(count)),
        });
      }
      const batch = { ...scratch.get(count), first, count, roots: keep(this.#dq8.motions(count)) };
      this.#motions(this.roots.subarray(7 * first, 7 * (first + count)), batch.roots);
      batch.palette = floats(16 * count * JOINTS);
      this.batches.push(batch);
    }
    this.plain = undefined;
  }
  /** Everybody at a pace of their own; `run` from 0, when all walk, to 1, when all run. */
  advance(seconds, run) {
    const { at, atRun, pace, weights } = this;
    for (let i = 0; i < this.people; i++) {
      const a = at[i] + 24 * seconds * pace[i],
        b = atRun[i] + 40 * seconds * pace[i];
      at[i] = a < LOOP ? a : a % LOOP;
      atRun[i] = b < LOOP ? b : b % LOOP;
      weights[i] = Math.min(1, Math.max(0, 2 * run - 1 + ((i * 0.377) % 1)));
    }
  }
  /** The palettes of a batch, and how long dq8 took, without what says where the ground is. */
  compute({ first, count, roots, models, inputs, targets, poles, palette }, clock) {
    const [at, atRun, weights] = inputs,
      [walk, run] = this.#clips,
      skeleton = this.#skeleton;
    [this.at, this.atRun, this.weights].forEach((all, k) => inputs[k].view.set(all.subarray(first, first + count)));
    const start = clock();
    skeleton.localToModel(walk.sample(at).blend(run.sample(atRun), weights), models, { roots });
    LIMBS.forEach(([, , foot], k) => this.#ankles(models.view, foot, targets[k].view, first, count));
    const before = clock();
    targets.forEach(({ view }, k) => {
      for (let i = 0; i < count; i++) {
        view[3 * i + 1] += this.heights[k][first + i] = ground(view[3 * i], view[3 * i + 2]);
      }
    });
    const after = clock();
    LIMBS.forEach((limb, k) => skeleton.twoBone(limb, models, targets[k], poles));
    skeleton.modelPalette(models, { inverseBinds: this.#inverseBinds, palette });
    return before - start + clock() - after;
  }
  /** Where ankles are, as high as the clip has them over flat ground. */
  #ankles(m, foot, targets, first, count) {
    const { roots } = this;
    for (let i = 0; i < count; i++) {
      const o = 8 * (i * JOINTS + foot),
        x = m[o],
        y = m[o + 1],
        z = m[o + 2],
        w = m[o + 3],
        a = m[o + 4],
        b = m[o + 5],
        c = m[o + 6],
        d = m[o + 7];
      targets[3 * i] = 2 * (w * a - d * x + y * c - z * b);
      targets[3 * i + 1] = 2 * (w * b - d * y + z * a - x * c) - roots[7 * (first + i) + 5];
      targets[3 * i + 2] = 2 * (w * c - d * z + x * b - y * a);
    }
  }
  all(clock) {
    return this.batches.reduce((sum, batch) => sum + this.compute(batch, clock), 0);
  }
  /** The same, to the same heights of the ground, as loops in JavaScript; how long they took. */
  allPlain(clock) {
    this.plain ??= this.#makePlain();
    const start = clock();
    animate(this.plain);
    return clock() - start;
  }
  #makePlain() {
    const { people, roots, heights } = this,
      poles = Float32Array.from({ length: 3 * people }, (_, i) => +(i % 3 === 2));
    const limbs = LIMBS.map((joints, k) => {
      const targets = new Float32Array(3 * people),
        o = 7 * joints[2];
      const aim = (M, i) => {
        targets[3 * i] = M[o + 4];
        targets[3 * i + 1] = M[o + 5] - roots[7 * i + 5] + heights[k][i];
        targets[3 * i + 2] = M[o + 6];
      };
      return { joints, ends: ENDS[k], targets, poles, aim };
    });
    return {
      parents, a: WALK, b: RUN, atA: this.at, atB: this.atRun, weights: this.weights, roots, binds, limbs,
      palette: new Float32Array(16 * people * JOINTS),
      models: new Float32Array(7 * JOINTS),
    };
  }
  /** The largest difference between the two palettes. */
  difference() {
    let most = 0;
    for (const { first, palette: { view } } of this.batches) {
      const from = 16 * JOINTS * first;
      for (let i = 0; i < view.length; i++) most = Math.max(most, Math.abs(view[i] - this.plain.palette[from + i]));
    }
    return most;
  }
  /** How far ankles are from where they should be, at most. */
  feet() {
    let most = 0;
    for (const batch of this.batches) {
      this.compute(batch, () => 0);
      LIMBS.forEach(([, , foot], k) => {
        for (let i = 0; i < batch.count; i++) {
          const target = batch.targets[k].view.subarray(3 * i, 3 * i + 3),
            at = place(batch.models.view, i * JOINTS + foot);
          most = Math.max(most, Math.hypot(...at.map((x, c) => x - target[c])));
        }
      });
    }
    return most;
  }
}

export function crowd(dq8, section) {
  const [slider, run, pause, button, compared] = ["#people", "#run", "#pause", "#compare", "#compared"].map((id) =>
    section.querySelector(id),
  );
  const people = new Crowd(dq8),
    clock = () => performance.now();
  let times,
    plainTimes,
    rounds,
    fresh,
    stage,
    told = 0,
    changed = false;
  const draw = () => {
    if (!scene.gl) return;
    stage ??= new Stage(scene.gl);
    stage.draw(scene.axes(), people.people, fresh ? people.batches.map(({ palette }) => palette) : []);
    fresh = false;
  };
  const step = (seconds) => {
    if (pause.checked && !rounds && !changed) return false;
    changed = false;
    frame(pause.checked ? 0 : seconds);
    return !pause.checked || rounds > 0;
  };
  const scene = new Scene(section, { yaw: 0.7, pitch: 0.5, draw, step }),
    state = { scene, crowd: people, frame, compare };
  const wanted = () => Math.max(1, Math.round((slider.value / 100) ** 2 * MOST));
  function frame(seconds) {
    if (wanted() !== people.people) {
      people.resize(wanted());
      [times, rounds] = [[], 0];
      compared.textContent = "";
    }
    people.advance(seconds, run.value / 100);
    state.taken = people.all(clock);
    times.push(state.taken);
    if (times.length > KEPT) times.shift();
    fresh = true;
    if (rounds) turn();
    tell();
  }
  function tell() {
    const taken = median(times);
    // Numbers that change in every frame cannot be read.
    if (times.length > 2 && clock() - told < 250) return;
    told = clock();
    const count = people.people.toLocaleString("en");
    scene.tell(
      `<b class="big b">${taken.toFixed(1)} ms</b> for ${count} ${people.people > 1 ? "people" : "person"}: ` +
        `two clips blended, feet on the ground, ${(people.people * JOINTS).toLocaleString("en")} matrices`,
    );
  }
  /** Starts a comparison; it goes on frame by frame. */
  function compare() {
    [rounds, plainTimes, times] = [WARM + ROUNDS, [], []];
    compared.textContent = "Both take turns.";
    scene.ask();
  }
  function turn() {
    plainTimes.push(people.allPlain(clock));
    if (--rounds === ROUNDS) [plainTimes, times] = [[], times.slice(-1)];
    if (rounds) return;
    const [a, b] = [median(times), median(plainTimes)];
    state.ratio = b / a;
    // The clock of a page is coarse.
    compared.textContent = `The same loops in plain JavaScript: ${b.toFixed(1)} ms, ` +
      (a < 0.5 ? "but there are too few to compare." : `${(b / a).toFixed(1)} times as long.`);
  }
  button.addEventListener("click", compare);
  for (const input of [slider, run, pause]) input.addEventListener("input", () => {
    changed = true;
    scene.ask();
  });
  pause.checked = matchMedia("(prefers-reduced-motion: reduce)").matches;
  frame(0);
  return state;
}
