// Rigid motions with a uniform scale, in doubles: rotation q = [x y z w], translation t, scale s.

/** The vector v, turned by the unit quaternion q. */
export function turn([x, y, z, w], [a, b, c]) {
  const [u, v, t] = [2 * (y * c - z * b), 2 * (z * a - x * c), 2 * (x * b - y * a)];
  return [a + w * u + y * t - z * v, b + w * v + z * u - x * t, c + w * t + x * v - y * u];
}

function unit([x, y, z, w]) {
  const n = Math.sqrt(x * x + y * y + z * z + w * w);
  return [x / n, y / n, z / n, w / n];
}

/** Writes the eight numbers of the motion with this rotation and this translation. */
export function writeMotion([x, y, z, w], [a, b, c], to, at) {
  to[at] = x;
  to[at + 1] = y;
  to[at + 2] = z;
  to[at + 3] = w;
  to[at + 4] = (a * w + b * z - c * y) / 2;
  to[at + 5] = (b * w + c * x - a * z) / 2;
  to[at + 6] = (c * w + a * y - b * x) / 2;
  to[at + 7] = -(a * x + b * y + c * z) / 2;
}

/** The quaternion of three columns that are perpendicular and of length 1. */
function rotation([a, b, c], [d, e, f], [g, h, i]) {
  const [w, x, y, z] = [1 + a + e + i, 1 + a - e - i, 1 - a + e - i, 1 - a - e + i],
    most = Math.max(w, x, y, z);
  if (most === w) return unit([f - h, g - c, b - d, w]);
  if (most === x) return unit([x, d + b, g + c, f - h]);
  if (most === y) return unit([d + b, y, h + f, g - c]);
  return unit([g + c, h + f, z, b - d]);
}

/** The one number that these scales are within a relative tolerance, or NaN. */
export function uniform(scales, tolerance) {
  const mean = (scales[0] + scales[1] + scales[2]) / 3;
  return scales.every((s) => Math.abs(s - mean) <= tolerance * Math.abs(mean)) && mean !== 0 ? mean : NaN;
}

/** q, t and s of a 4×4 matrix by columns, or a text that says why it has none. */
export function decompose(m, tolerance) {
  const columns = [0, 4, 8].map((k) => [m[k], m[k + 1], m[k + 2]]),
    [a, b, c] = columns;
  const dot = (u, v) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2],
    lengths = columns.map((u) => Math.sqrt(dot(u, u)));
  if (!Array.from({ length: 16 }, (_, k) => m[k]).every(Number.isFinite)) return "has a number that is not finite";
  if (Math.abs(m[3]) + Math.abs(m[7]) + Math.abs(m[11]) > 1e-6 || Math.abs(m[15] - 1) > 1e-6) return "is not affine";
  const size = uniform(lengths, tolerance);
  if (Number.isNaN(size)) return `scales its axes by ${lengths.map(short).join(", ")}, which is not uniform`;
  const skew =
    Math.max(
      ...[
        [a, b],
        [b, c],
        [c, a],
      ].map(([u, v]) => Math.abs(dot(u, v))),
    ) /
    (size * size);
  if (skew > 2 * tolerance) return "shears: its axes are not perpendicular";
  const volume =
    a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  const s = volume < 0 ? -size : size;
  // Each column by its own length, so that a scale within the tolerance turns nothing.
  const axes = columns.map((u, k) => u.map((x) => x / (Math.sign(s) * lengths[k])));
  return { q: rotation(...axes), t: [m[12], m[13], m[14]], s };
}

/**
 * Motions, eight numbers each, of 4×4 matrices by columns, which turn and move and neither scale nor
 * shear.
 */
export function fromMatrices(matrices) {
  const { length } = matrices,
    motions = new Float32Array(length / 2);
  if (length % 16) throw new RangeError(`matrices holds ${length} numbers, which is not a multiple of 16`);
  for (let i = 0; 16 * i < length; i++) {
    const parts = decompose(matrices.slice(16 * i, 16 * i + 16), 1e-3);
    if (typeof parts === "string") throw new RangeError(`matrices[${i}] ${parts}`);
    if (!(Math.abs(parts.s - 1) < 1e-3))
      throw new RangeError(`matrices[${i}] scales by ${parts.s}, and motions do not`);
    writeMotion(parts.q, parts.t, motions, 8 * i);
  }
  return motions;
}

/** A number as errors have it. */
export const short = (x) => String(Number(x.toPrecision(6)));
