// The same in plain JavaScript, loops over flat arrays written out: what dq8 is measured against, here and on the page.

/** Models of motions of eight numbers. */
export function localToModel(parents, locals, models) {
  const joints = parents.length, L = locals, M = models;
  for (let first = 0; first < L.length; first += 8 * joints) for (let j = 0; j < joints; j++) {
    const o = first + 8 * j, up = parents[j];
    if (up < 0) { for (let k = o; k < o + 8; k++) M[k] = L[k]; continue; }
    const p = first + 8 * up;
    const ax = M[p], ay = M[p + 1], az = M[p + 2], aw = M[p + 3];
    const ex = M[p + 4], ey = M[p + 5], ez = M[p + 6], ew = M[p + 7];
    const bx = L[o], by = L[o + 1], bz = L[o + 2], bw = L[o + 3];
    const fx = L[o + 4], fy = L[o + 5], fz = L[o + 6], fw = L[o + 7];
    M[o] = aw * bx + ax * bw + ay * bz - az * by; M[o + 1] = aw * by + ay * bw + az * bx - ax * bz;
    M[o + 2] = aw * bz + az * bw + ax * by - ay * bx; M[o + 3] = aw * bw - ax * bx - ay * by - az * bz;
    M[o + 4] = aw * fx + ax * fw + ay * fz - az * fy + ew * bx + ex * bw + ey * bz - ez * by;
    M[o + 5] = aw * fy + ay * fw + az * fx - ax * fz + ew * by + ey * bw + ez * bx - ex * bz;
    M[o + 6] = aw * fz + az * fw + ax * fy - ay * fx + ew * bz + ez * bw + ex * by - ey * bx;
    M[o + 7] = aw * fw - ax * fx - ay * fy - az * fz + ew * bw - ex * bx - ey * by - ez * bz;
  }
}

/**
 * Two clips of [frame][joint][x y z w tx ty tz], blended, to 4×4 palettes by columns. `roots` are [x y z w tx ty tz]
 * of each instance, `binds` of each joint; `limbs` are [{ joints: [hip, knee, foot], ends, targets, poles, aim }],
 * `ends` the joints after the last that hang from each, `aim` what sets the target of an instance from its models.
 */
export function animate({ parents, a, b, atA, atB, weights, roots, binds, palette, models, limbs = [] }) {
  const joints = parents.length, n = weights.length, row = 7 * joints;
  const lastA = a.length / row - 2, lastB = b.length / row - 2;
  for (let i = 0; i < n; i++) {
    const fa = Math.min(atA[i] | 0, lastA), ta = atA[i] - fa, sa = 1 - ta, fb = Math.min(atB[i] | 0, lastB),
      tb = atB[i] - fb, sb = 1 - tb;
    const w = weights[i], u = 1 - w;
    for (let j = 0, o = row * fa, e = row * fb; j < joints; j++, o += 7, e += 7) {
      const p = o + row, g = e + row;
      let s = a[o] * a[p] + a[o + 1] * a[p + 1] + a[o + 2] * a[p + 2] + a[o + 3] * a[p + 3] < 0 ? -ta : ta;
      let x = sa * a[o] + s * a[p], y = sa * a[o + 1] + s * a[p + 1], z = sa * a[o + 2] + s * a[p + 2],
        q = sa * a[o + 3] + s * a[p + 3];
      let r = u / Math.sqrt(x * x + y * y + z * z + q * q);
      s = b[e] * b[g] + b[e + 1] * b[g + 1] + b[e + 2] * b[g + 2] + b[e + 3] * b[g + 3] < 0 ? -tb : tb;
      const ex = sb * b[e] + s * b[g], ey = sb * b[e + 1] + s * b[g + 1], ez = sb * b[e + 2] + s * b[g + 2],
        eq = sb * b[e + 3] + s * b[g + 3];
      let v = w / Math.sqrt(ex * ex + ey * ey + ez * ez + eq * eq);
      if (x * ex + y * ey + z * ez + q * eq < 0) v = -v;
      x = r * x + v * ex; y = r * y + v * ey; z = r * z + v * ez; q = r * q + v * eq;
      r = 1 / Math.sqrt(x * x + y * y + z * z + q * q); x *= r; y *= r; z *= r; q *= r;
      const px = u * (sa * a[o + 4] + ta * a[p + 4]) + w * (sb * b[e + 4] + tb * b[g + 4]);
      const py = u * (sa * a[o + 5] + ta * a[p + 5]) + w * (sb * b[e + 5] + tb * b[g + 5]);
      const pz = u * (sa * a[o + 6] + ta * a[p + 6]) + w * (sb * b[e + 6] + tb * b[g + 6]);
      const up = parents[j];
      if (up < 0) product(roots, 7 * i, x, y, z, q, px, py, pz, models, 7 * j);
      else product(models, 7 * up, x, y, z, q, px, py, pz, models, 7 * j);
    }
    for (const limb of limbs) { limb.aim?.(models, i); twoBone(models, limb, i); }
    for (let j = 0; j < joints; j++) {
      const o = 7 * j;
      product(models, o, binds[o], binds[o + 1], binds[o + 2], binds[o + 3], binds[o + 4], binds[o + 5], binds[o + 6],
        moved, 0);
      matrix(moved, palette, 16 * (i * joints + j));
    }
  }
}
const moved = new Float64Array(7);

function product(A, o, x, y, z, q, a, b, c, to, at) {
  const ax = A[o], ay = A[o + 1], az = A[o + 2], aw = A[o + 3];
  const tx = 2 * (ay * c - az * b), ty = 2 * (az * a - ax * c), tz = 2 * (ax * b - ay * a);
  to[at + 4] = A[o + 4] + a + aw * tx + ay * tz - az * ty;
  to[at + 5] = A[o + 5] + b + aw * ty + az * tx - ax * tz;
  to[at + 6] = A[o + 6] + c + aw * tz + ax * ty - ay * tx;
  to[at] = aw * x + ax * q + ay * z - az * y; to[at + 1] = aw * y + ay * q + az * x - ax * z;
  to[at + 2] = aw * z + az * q + ax * y - ay * x; to[at + 3] = aw * q - ax * x - ay * y - az * z;
}

function matrix(A, P, o) {
  const x = A[0], y = A[1], z = A[2], w = A[3];
  P[o] = 1 - 2 * (y * y + z * z); P[o + 1] = 2 * (x * y + z * w); P[o + 2] = 2 * (x * z - y * w); P[o + 3] = 0;
  P[o + 4] = 2 * (x * y - z * w); P[o + 5] = 1 - 2 * (x * x + z * z); P[o + 6] = 2 * (y * z + x * w); P[o + 7] = 0;
  P[o + 8] = 2 * (x * z + y * w); P[o + 9] = 2 * (y * z - x * w); P[o + 10] = 1 - 2 * (x * x + y * y); P[o + 11] = 0;
  P[o + 12] = A[4]; P[o + 13] = A[5]; P[o + 14] = A[6]; P[o + 15] = 1;
}

/** The least turn of a bone to a way, about a point, and then that point to another. */
function swing(M, first, after, bone, way, from, to) {
  const a = bone[0], b = bone[1], c = bone[2], x = way[0], y = way[1], z = way[2];
  const r = 1 / Math.sqrt(a * a + b * b + c * c), s = 1 / Math.sqrt(x * x + y * y + z * z);
  let cx = (b * z - c * y) * r * s, cy = (c * x - a * z) * r * s, cz = (a * y - b * x) * r * s,
    w = 1 + (a * x + b * y + c * z) * r * s;
  const n = 1 / Math.sqrt(cx * cx + cy * cy + cz * cz + w * w);
  cx *= n; cy *= n; cz *= n; w *= n;
  const turn = [cx, cy, cz, w, to[0], to[1], to[2]];
  for (let o = 7 * first; o < 7 * after; o += 7) {
    product(turn, 0, M[o], M[o + 1], M[o + 2], M[o + 3], M[o + 4] - from[0], M[o + 5] - from[1], M[o + 6] - from[2],
      M, o);
  }
}

const place = (M, joint) => [M[7 * joint + 4], M[7 * joint + 5], M[7 * joint + 6]];
const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const size = (a) => Math.sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

function twoBone(M, { joints: [hip, knee, foot], ends, targets, poles }, i) {
  const h = place(M, hip), k = place(M, knee), f = place(M, foot),
    goal = [targets[3 * i], targets[3 * i + 1], targets[3 * i + 2]];
  const [a, b] = [size(minus(k, h)), size(minus(f, k))], way = minus(goal, h), far = size(way);
  const d = Math.min(a + b, Math.max(Math.abs(a - b), far)), along = far > 0 ? way.map((x) => x / far) : [1, 0, 0];
  const cosine = (a * a + d * d - b * b) / (2 * a * d), sine = Math.sqrt(Math.max(0, 1 - cosine * cosine));
  const pole = [poles[3 * i], poles[3 * i + 1], poles[3 * i + 2]], part = dot(pole, along);
  const across = pole.map((x, c) => x - part * along[c]), length = size(across) || 1;
  const upper = along.map((x, c) => a * (cosine * x + sine * across[c] / length)),
    newKnee = h.map((x, c) => x + upper[c]);
  const lower = h.map((x, c) => x + d * along[c] - newKnee[c]), end = newKnee.map((x, c) => x + lower[c] - f[c]);
  const thigh = minus(k, h), shin = minus(f, k);
  // From the hip what does not hang from the knee, and so on.
  swing(M, hip, knee, thigh, upper, h, h);
  swing(M, knee, foot, shin, lower, k, newKnee);
  for (let o = 7 * foot; o < 7 * ends[2]; o += 7) for (let c = 0; c < 3; c++) M[o + 4 + c] += end[c];
  swing(M, ends[2], ends[1], shin, lower, k, newKnee);
  swing(M, ends[1], ends[0], thigh, upper, h, h);
}

/** Four influences of matrices of twelve numbers, rows. */
export function skinLinear(joints, weights, matrices, rest, posed) {
  const m = matrices;
  for (let v = 0, i = 0; v < rest.length; v += 3, i += 4) {
    const p = 12 * joints[i], q = 12 * joints[i + 1], r = 12 * joints[i + 2], s = 12 * joints[i + 3];
    const a = weights[i], b = weights[i + 1], c = weights[i + 2], d = weights[i + 3], x = rest[v], y = rest[v + 1],
      z = rest[v + 2];
    for (let k = 0, o = 0; k < 3; k++, o += 4) {
      posed[v + k] = (a * m[p + o] + b * m[q + o] + c * m[r + o] + d * m[s + o]) * x
        + (a * m[p + o + 1] + b * m[q + o + 1] + c * m[r + o + 1] + d * m[s + o + 1]) * y
        + (a * m[p + o + 2] + b * m[q + o + 2] + c * m[r + o + 2] + d * m[s + o + 2]) * z + a * m[p + o + 3]
        + b * m[q + o + 3] + c * m[r + o + 3] + d * m[s + o + 3];
    }
  }
}

/** Four influences of motions, each with the sign that turns it toward the one of the greatest weight. */
export function skinDual(joints, weights, motions, rest, posed) {
  const m = motions, sum = new Float64Array(8);
  for (let v = 0, i = 0; v < rest.length; v += 3, i += 4) {
    let most = i;
    for (let k = i + 1; k < i + 4; k++) if (weights[k] > weights[most]) most = k;
    const p = 8 * joints[most];
    sum.fill(0);
    for (let k = i; k < i + 4; k++) {
      const o = 8 * joints[k], same = m[o] * m[p] + m[o + 1] * m[p + 1] + m[o + 2] * m[p + 2] + m[o + 3] * m[p + 3],
        w = same < 0 ? -weights[k] : weights[k];
      for (let c = 0; c < 8; c++) sum[c] += w * m[o + c];
    }
    const x = sum[0], y = sum[1], z = sum[2], w = sum[3], a = sum[4], b = sum[5], c = sum[6], d = sum[7],
      n = 1 / (x * x + y * y + z * z + w * w), px = rest[v], py = rest[v + 1], pz = rest[v + 2];
    const tx = y * pz - z * py + w * px, ty = z * px - x * pz + w * py, tz = x * py - y * px + w * pz;
    posed[v] = px + 2 * n * (y * tz - z * ty + w * a - d * x + y * c - z * b);
    posed[v + 1] = py + 2 * n * (z * tx - x * tz + w * b - d * y + z * a - x * c);
    posed[v + 2] = pz + 2 * n * (x * ty - y * tx + w * c - d * z + x * b - y * a);
  }
}
