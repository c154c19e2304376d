// Where motions of eight numbers take points.

/** The translation of motion `i`. */
export function place(m, i) {
  const o = 8 * i;
  const [x, y, z, w] = [m[o], m[o + 1], m[o + 2], m[o + 3]],
    [a, b, c, d] = [m[o + 4], m[o + 5], m[o + 6], m[o + 7]];
  const half = [w * a - d * x + y * c - z * b, w * b - d * y + z * a - x * c, w * c - d * z + x * b - y * a];
  return half.map((value) => 2 * value);
}

/** A point moved by motion `i`. */
export function move(m, i, [a, b, c]) {
  const o = 8 * i,
    [x, y, z, w] = [m[o], m[o + 1], m[o + 2], m[o + 3]],
    t = place(m, i);
  const [p, q, r] = [y * c - z * b + w * a, z * a - x * c + w * b, x * b - y * a + w * c];
  return [a + 2 * (y * r - z * q) + t[0], b + 2 * (z * p - x * r) + t[1], c + 2 * (x * q - y * p) + t[2]];
}
