// Numbers over time, as files have them: LINEAR (rotations by slerp), STEP and CUBICSPLINE of glTF.

const slerp = (a, b, t, out) => {
  let cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3],
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
  for (let k = 0; k < 4; k++) out[k] = from * a[k] + sign * to * b[k];
};

/** Rotations (`width` 4) or vectors of one node over time. */
export class Track {
  #times;
  #values;
  #width;
  #kind;
  #next = 1;
  #a;
  #b;
  constructor(times, values, width, kind = "LINEAR") {
    this.#times = times;
    this.#values = values;
    this.#width = width;
    this.#kind = kind;
    [this.#a, this.#b] = [new Float64Array(width), new Float64Array(width)];
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
  /** Part `part` of key `key`: a cubic spline has a tangent in, the value and a tangent out. */
  #key(key, to, part = 1) {
    const width = this.#width,
      from = (this.#kind === "CUBICSPLINE" ? 3 * key + part : key) * width;
    for (let k = 0; k < width; k++) to[k] = this.#values[from + k];
    return to;
  }
  /**
   * Writes the numbers at a time: before the first key those of the first, after the last those of
   * the last.
   */
  at(time, out) {
    const times = this.#times,
      next = this.#after(time),
      kind = this.#kind;
    if (next === 0 || next === times.length || kind === "STEP") {
      this.#key(Math.max(next - 1, 0), out);
      return;
    }
    const span = times[next] - times[next - 1],
      t = (time - times[next - 1]) / span;
    const a = this.#key(next - 1, this.#a),
      b = this.#key(next, this.#b);
    if (kind === "CUBICSPLINE") {
      const t2 = t * t,
        t3 = t2 * t,
        [from, to] = [2 * t3 - 3 * t2 + 1, 3 * t2 - 2 * t3];
      for (let k = 0; k < out.length; k++) out[k] = from * a[k] + to * b[k];
      const [leave, arrive] = [this.#key(next - 1, a, 2), this.#key(next, b, 0)];
      for (let k = 0; k < out.length; k++) out[k] += span * ((t3 - 2 * t2 + t) * leave[k] + (t3 - t2) * arrive[k]);
    } else if (this.#width === 4) slerp(a, b, t, out);
    else for (let k = 0; k < out.length; k++) out[k] = a[k] + t * (b[k] - a[k]);
  }
}
