// Frames of all joints at a rate, and by how much poses between frames miss the tracks.
import { short, turn } from "./rigid.js";

const PATHS = ["rotation", "translation"];

/**
 * What a joint does in a clip: `fixed` that is above it, then its rotation and translation, of
 * tracks or at rest, the latter times `size`.
 */
export class Local {
  #rotation;
  #translation;
  #tracks;
  #fixed;
  #size;
  #where;
  constructor(node, fixed, size, tracks = {}, whose = "") {
    [this.#rotation, this.#translation] = PATHS.map((path) => Float64Array.from(node[path]));
    this.#fixed = fixed;
    this.#size = size;
    this.#tracks = tracks;
    this.#where = `${whose}${node.place}`;
  }
  get tracks() {
    return PATHS.map((path) => this.#tracks[path]).filter(Boolean);
  }
  /**
   * Writes [x y z w tx ty tz] at a time; a step is taken as soon as its time has come, but for
   * `slack`.
   */
  at(time, slack, out) {
    const { rotation, translation } = this.#tracks,
      q = this.#rotation,
      t = this.#translation,
      size = this.#size;
    rotation?.at(rotation.steps ? time + slack : time, q);
    translation?.at(translation.steps ? time + slack : time, t);
    const length = Math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    if (!(length > 0 && length < Infinity))
      throw new Error(`${this.#where} at ${short(time)} s: rotation is ${q}, which is none`);
    if (!Number.isFinite(t[0] + t[1] + t[2]))
      throw new Error(`${this.#where} at ${short(time)} s: translation is ${t}`);
    for (let k = 0; k < 4; k++) out[k] = q[k] / length;
    for (let k = 0; k < 3; k++) out[4 + k] = size * t[k];
    if (this.#fixed) below(this.#fixed, out);
  }
}

/** Multiplies a motion [x y z w tx ty tz] from the left to another. */
function below([a, b, c, d, tx, ty, tz], out) {
  const [x, y, z, w] = out,
    moved = turn([a, b, c, d], out.subarray(4));
  out[0] = d * x + a * w + b * z - c * y;
  out[1] = d * y + b * w + c * x - a * z;
  out[2] = d * z + c * w + a * y - b * x;
  out[3] = d * w - a * x - b * y - c * z;
  out[4] = tx + moved[0];
  out[5] = ty + moved[1];
  out[6] = tz + moved[2];
}

/**
 * How far the pose part of the way between two keys, as `dq8` has it, is from another: half a sine
 * and a distance, squared.
 */
class Gap {
  turned = 0;
  moved = 0;
  between(keys, a, b, part, wanted) {
    const dot = keys[a] * keys[b] + keys[a + 1] * keys[b + 1] + keys[a + 2] * keys[b + 2] + keys[a + 3] * keys[b + 3];
    const from = 1 - part,
      to = dot < 0 ? -part : part;
    const x = from * keys[a] + to * keys[b],
      y = from * keys[a + 1] + to * keys[b + 1],
      z = from * keys[a + 2] + to * keys[b + 2],
      w = from * keys[a + 3] + to * keys[b + 3];
    const p = wanted[0],
      q = wanted[1],
      r = wanted[2],
      s = wanted[3],
      u = w * p - s * x + z * q - y * r,
      v = w * q - s * y + x * r - z * p,
      t = w * r - s * z + y * p - x * q;
    this.turned = (u * u + v * v + t * t) / (x * x + y * y + z * z + w * w);
    let moved = 0;
    for (let k = 4; k < 7; k++) moved += (wanted[k] - from * keys[a + k] - part * keys[b + k]) ** 2;
    this.moved = moved;
  }
}

/** Frames of a clip at a rate. To measure the error takes longer than to make the frames. */
export function resample(clip, locals, wanted, measured = true) {
  const joints = locals.length,
    stride = 7 * joints,
    steps = clip.duration * wanted,
    near = Math.round(steps);
  // A frame lies on the end, so that a loop has its length.
  const intervals = Math.max(1, Math.abs(steps - near) < 1e-3 ? near : Math.ceil(steps)),
    frames = intervals + 1;
  const rate = clip.duration > 0 ? intervals / clip.duration : wanted,
    slack = 1e-3 / rate;
  if (!(stride * frames < 2 ** 28)) {
    throw new Error(
      `${clip.place}: ${short(clip.duration)} s of ${joints} joints at ${wanted} frames a second ` +
        "are more than memory holds",
    );
  }
  const keys = new Float32Array(stride * frames),
    out = new Float64Array(7),
    gap = new Gap(),
    most = measured ? { turned: 0, moved: 0 } : { turned: NaN, moved: NaN };
  locals.forEach((local, joint) => {
    const { tracks } = local;
    for (let f = 0, to = 7 * joint; f < frames; f++, to += stride) {
      if (f === 0 || tracks.length) local.at(f / rate, slack, out);
      for (let k = 0; k < 7; k++) keys[to + k] = out[k];
    }
    const measure = (f, part) => {
      const time = (f + part) / rate,
        a = f * stride + 7 * joint;
      local.at(time, slack, out);
      gap.between(keys, a, a + stride, part, out);
      for (const kind of ["turned", "moved"]) {
        if (gap[kind] > most[kind]) Object.assign(most, { [kind]: gap[kind], [`${kind}At`]: { joint, time } });
      }
    };
    if (!tracks.length || !measured) return;
    // A spline or a slerp is farthest near a quarter or a half of a frame, straight tracks at their
    // keys.
    for (let f = 0; f < intervals; f++) {
      measure(f, 0.25);
      measure(f, 0.5);
      measure(f, 0.75);
    }
    for (const { times } of tracks)
      for (const time of times) {
        const f = Math.floor(time * rate),
          part = time * rate - f;
        if (f < intervals && part > 1e-3 && part < 0.999) measure(f, part);
      }
  });
  const error = {
    rotation: 2 * Math.asin(Math.min(1, Math.sqrt(most.turned))),
    translation: Math.sqrt(most.moved),
    rotationAt: most.turnedAt,
    translationAt: most.movedAt,
  };
  return { name: clip.name, keys, rate, frames, duration: clip.duration, error };
}
