// Numbers over time, as files have them: LINEAR (rotations by slerp), STEP and CUBICSPLINE of glTF.

/** From the rotation at `a` to that at `b` in an array of them. */
const slerp = (v, a, b, t, out) => {
  let cosine = v[a] * v[b] + v[a + 1] * v[b + 1] + v[a + 2] * v[b + 2] + v[a + 3] * v[b + 3],
    from = 1 - t,
    to = t;
  const sign = cosine < 0 ? -1 : 1;
  cosine *= sign;
  // Below, the sine would lose the angle, and weights that add to 1 differ by less than 1e-7.
  if (cosine < 0.9999) {
    const angle = Math.acos(cosine),
      sine = Math.sin(angle);
    from = Math.sin(from * angle) / sine;
    to = Math.sin(to * angle) / sine;
  }
  to *= sign;
  for (let k = 0; k < 4; k++) out[k] = from * v[a + k] + to * v[b + k];
};

/** Rotations (`width` 4) or vectors of one node over time. */
export class Track {
  #times;
  #values;
  #width;
  #kind;
  #next = 1;
  constructor(times, values, width, kind = "LINEAR") {
    this.#times = times;
    this.#values = values;
    this.#width = width;
    this.#kind = kind;
  }
  get times() {
    return this.#times;
  }
  get steps() {
    return this.#kind === "STEP";
  }
  /** The number of the key after a time. Times that rise, as those of frames, are found at once. */
  #after(time) {
    const times = this.#times;
    let next = this.#next;
    if (times[next - 1] > time) {
      let low = 0;
      for (let high = next - 1; low < high;) {
        const middle = (low + high) >> 1;
        if (times[middle] > time) high = middle;
        else low = middle + 1;
      }
      next = low;
    }
    while (next < times.length && times[next] <= time) next++;
    return ((this.#next = Math.max(next, 1)), next);
  }
  /**
   * Writes the numbers at a time: before the first key those of the first, after the last those of
   * the last.
   */
  at(time, out) {
    const times = this.#times,
      v = this.#values,
      width = this.#width,
      kind = this.#kind,
      next = this.#after(time),
      held = next === 0 || next === times.length || kind === "STEP",
      key = Math.max(next - 1, 0);
    // A cubic spline has a tangent in, the value and a tangent out.
    const stride = kind === "CUBICSPLINE" ? 3 * width : width,
      a = stride * key + (kind === "CUBICSPLINE" ? width : 0),
      b = a + stride;
    if (held) {
      for (let k = 0; k < width; k++) out[k] = v[a + k];
      return;
    }
    const span = times[next] - times[key],
      t = (time - times[key]) / span;
    if (kind === "CUBICSPLINE") {
      const t2 = t * t,
        t3 = t2 * t,
        to = 3 * t2 - 2 * t3,
        [leave, arrive] = [span * (t3 - 2 * t2 + t), span * (t3 - t2)];
      for (let k = 0; k < width; k++)
        out[k] = (1 - to) * v[a + k] + to * v[b + k] + leave * v[a + width + k] + arrive * v[b - width + k];
    } else if (width === 4) slerp(v, a, b, t, out);
    else for (let k = 0; k < width; k++) out[k] = v[a + k] + t * (v[b + k] - v[a + k]);
  }
}
