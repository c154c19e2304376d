// A canvas, and a camera that goes around what it shows.
const probe = document.createElement("span");
document.body.append(probe);
/** A colour of the page, as the scheme has it. */
export const colour = (name) => { probe.style.color = `var(${name})`; return getComputedStyle(probe).color; };

export class Scene {
  constructor(section, { yaw = 0.6, pitch = 0.35, size = 3, centre = [0, 0, 0], flat = true, orbit = true } = {}) {
    this.canvas = section.querySelector("canvas");
    this.output = section.querySelector("output");
    Object.assign(this, { yaw, pitch, size, centre });
    this.context = flat ? this.canvas.getContext("2d") : null;
    new ResizeObserver(() => { this.fit(); this.draw?.(); }).observe(this.canvas);
    this.fit();
    if (orbit) this.#orbit();
  }
  fit() {
    const { clientWidth, clientHeight } = this.canvas, density = Math.min(2, devicePixelRatio || 1);
    this.canvas.width = Math.max(1, Math.round(clientWidth * density));
    this.canvas.height = Math.max(1, Math.round(clientHeight * density));
  }
  #orbit() {
    const turn = (x, y) => { this.yaw += x; this.pitch = Math.max(-1.5, Math.min(1.5, this.pitch + y)); this.draw?.(); };
    this.canvas.addEventListener("pointerdown", (event) => this.canvas.setPointerCapture(event.pointerId));
    this.canvas.addEventListener("pointermove", (event) => { if (event.buttons) turn(event.movementX * 0.01, event.movementY * 0.01); });
    this.canvas.addEventListener("keydown", (event) => {
      const way = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] }[event.key];
      if (way) { turn(...way); event.preventDefault(); }
    });
  }
  /** Rows: right, up, toward the viewer. y is up. */
  axes() {
    const [s, c, t, d] = [Math.sin(this.yaw), Math.cos(this.yaw), Math.sin(this.pitch), Math.cos(this.pitch)];
    return [[c, 0, -s], [-s * t, d, -c * t], [s * d, t, c * d]];
  }
  /** Pixels and depth of a point. */
  project() {
    const [r, u, f] = this.axes(), { width, height } = this.canvas, scale = Math.min(width / 1.5, height) / this.size, [a, b, c] = this.centre;
    return (x, y, z) => {
      x -= a; y -= b; z -= c;
      return [width / 2 + scale * (r[0] * x + r[1] * y + r[2] * z), height / 2 - scale * (u[0] * x + u[1] * y + u[2] * z), f[0] * x + f[1] * y + f[2] * z];
    };
  }
  clear() { this.context.clearRect(0, 0, this.canvas.width, this.canvas.height); }
  line(points, stroke, width = 2) {
    const { context } = this;
    context.strokeStyle = stroke; context.lineWidth = width * Math.min(2, devicePixelRatio || 1); context.lineCap = context.lineJoin = "round";
    context.beginPath();
    points.forEach(([x, y], i) => (i ? context.lineTo(x, y) : context.moveTo(x, y)));
    context.stroke();
  }
  /** Triangles of points, from far to near, lit from above the viewer. */
  triangles(points, indices, [red, green, blue], project = this.project()) {
    const faces = [], p = Array.from({ length: points.length / 3 }, (_, i) => project(points[3 * i], points[3 * i + 1], points[3 * i + 2]));
    for (let i = 0; i < indices.length; i += 3) faces.push([indices[i], indices[i + 1], indices[i + 2]]);
    faces.sort((a, b) => p[a[0]][2] + p[a[1]][2] + p[a[2]][2] - p[b[0]][2] - p[b[1]][2] - p[b[2]][2]);
    const { context } = this, unit = Math.min(this.canvas.width / 1.5, this.canvas.height) / this.size;
    for (const [i, j, k] of faces) {
      const a = [p[j][0] - p[i][0], p[i][1] - p[j][1], (p[j][2] - p[i][2]) * unit], b = [p[k][0] - p[i][0], p[i][1] - p[k][1], (p[k][2] - p[i][2]) * unit];
      const n = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
      const light = 0.35 + 0.65 * Math.abs(0.3 * n[0] + 0.5 * n[1] + 0.8 * n[2]) / (Math.hypot(...n) || 1);
      context.fillStyle = context.strokeStyle = `rgb(${red * light | 0} ${green * light | 0} ${blue * light | 0})`;
      context.lineWidth = 1;
      context.beginPath(); context.moveTo(p[i][0], p[i][1]); context.lineTo(p[j][0], p[j][1]); context.lineTo(p[k][0], p[k][1]); context.closePath();
      context.fill(); context.stroke();
    }
  }
}
export const rgb = (name) => colour(name).match(/[\d.]+/g).slice(0, 3).map(Number);
/** The translation of motion `i`. */
export function place(m, i) {
  const o = 8 * i, x = m[o], y = m[o + 1], z = m[o + 2], w = m[o + 3], a = m[o + 4], b = m[o + 5], c = m[o + 6], d = m[o + 7];
  return [2 * (w * a - d * x + y * c - z * b), 2 * (w * b - d * y + z * a - x * c), 2 * (w * c - d * z + x * b - y * a)];
}
/** A point moved by motion `i`. */
export function move(m, i, [a, b, c]) {
  const o = 8 * i, x = m[o], y = m[o + 1], z = m[o + 2], w = m[o + 3], t = place(m, i);
  const p = y * c - z * b + w * a, q = z * a - x * c + w * b, r = x * b - y * a + w * c;
  return [a + 2 * (y * r - z * q) + t[0], b + 2 * (z * p - x * r) + t[1], c + 2 * (x * q - y * p) + t[2]];
}
