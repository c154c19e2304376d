// A panel: two canvases, of solids below and of lines and words above, and a camera that goes
// around.
import { NO_WEBGL, Solids } from "./gl.js";

const probe = document.createElement("span");
document.body.append(probe);
/** A colour of the page, as the scheme has it. */
export const colour = (name) => {
  probe.style.color = `var(${name})`;
  return getComputedStyle(probe).color;
};
export const rgb = (name) => colour(name).match(/[\d.]+/g).slice(0, 3).map(Number);
const density = () => Math.min(2, devicePixelRatio || 1);

// Numbers that move are not read aloud; where they come to rest, after a while, is.
let later;
function say(text) {
  clearTimeout(later);
  later = setTimeout(() => (document.getElementById("said").textContent = text), 800);
}

/**
 * Calls back with how far a pointer that is down has gone, in pixels right and down. Of fingers,
 * only with those that `grips` takes.
 */
export function dragged(canvas, back, grips = () => true) {
  let x,
    y,
    held = false;
  canvas.addEventListener("pointerdown", (event) => {
    held = event.pointerType !== "touch" || grips(event);
    if (held) canvas.setPointerCapture(event.pointerId);
    [x, y] = [event.clientX, event.clientY];
  });
  canvas.addEventListener("pointermove", (event) => {
    if (!event.buttons || !held) return;
    back(event.clientX - x, event.clientY - y);
    [x, y] = [event.clientX, event.clientY];
  });
}

/** Calls back with an arrow key: right, down, and whether Shift is held. */
export function arrows(canvas, back) {
  const WAYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
  canvas.addEventListener("keydown", (event) => {
    const way = WAYS[event.key];
    if (!way) return;
    event.preventDefault();
    back(...way, event.shiftKey);
  });
}

/** Text from a file as HTML that shows it and nothing else. */
export const escaped = (text) => text.replace(/[&<>]/g, (letter) => `&#${letter.charCodeAt()};`);

export class Scene {
  #asked = false;
  #before = 0;
  #numbers;
  /** How often it was drawn. */
  draws = 0;
  seen = false;
  constructor(section, { yaw, pitch, size = 3, centre = [0, 0, 0], orbit = true, solid = true, draw, step }) {
    const canvas = section.querySelector("canvas");
    Object.assign(this, { canvas, yaw, pitch, size, centre, draw, step });
    this.#numbers = section.querySelector(".numbers");
    this.context = canvas.getContext("2d");
    if (solid) {
      this.below = document.createElement("canvas");
      this.below.setAttribute("aria-hidden", true);
      canvas.before(this.below);
      this.gl = this.below.getContext("webgl2", { antialias: true });
      if (!this.gl) section.querySelector(".missing").textContent = NO_WEBGL;
    }
    new ResizeObserver(() => {
      this.#fit();
      this.ask();
    }).observe(canvas);
    new IntersectionObserver((entries) => {
      this.seen = entries.at(-1).isIntersecting;
      this.ask();
    }).observe(canvas);
    this.#fit();
    if (!orbit) return;
    const turn = (x, y) => {
      this.yaw += x;
      this.pitch = Math.max(-1.5, Math.min(1.5, this.pitch + y));
      this.ask();
    };
    dragged(canvas, (right, down) => turn(0.01 * right, 0.01 * down));
    arrows(canvas, (right, down) => turn(0.1 * right, 0.1 * down));
  }
  #fit() {
    const { clientWidth, clientHeight } = this.canvas;
    for (const canvas of [this.canvas, ...(this.below ? [this.below] : [])]) {
      canvas.width = Math.max(1, Math.round(clientWidth * density()));
      canvas.height = Math.max(1, Math.round(clientHeight * density()));
    }
  }
  /** Draws at the next frame, or, out of view, when it is in view again. */
  ask() {
    if (this.#asked || !this.seen) return;
    this.#asked = true;
    requestAnimationFrame((now) => {
      this.#asked = false;
      if (!this.seen) return;
      const seconds = Math.min(0.1, (now - this.#before) / 1000);
      this.#before = now;
      const goesOn = this.step?.(seconds);
      this.draws++;
      this.draw();
      if (goesOn) this.ask();
    });
  }
  /** The line of numbers, as HTML; `aloud` for screen readers too, if somebody has asked for it. */
  tell(html, aloud = false) {
    if (this.#numbers.innerHTML === html) return;
    this.#numbers.innerHTML = html;
    if (aloud) say(this.#numbers.textContent);
  }
  /** Rows: right, up, toward the viewer. y is up. */
  axes() {
    const [s, c, t, d] = [Math.sin(this.yaw), Math.cos(this.yaw), Math.sin(this.pitch), Math.cos(this.pitch)];
    return [[c, 0, -s], [-s * t, d, -c * t], [s * d, t, c * d]];
  }
  /** Pixels of the canvas for a unit. */
  get scale() {
    return Math.min(this.canvas.width / 1.25, this.canvas.height) / this.size;
  }
  set scale(pixels) {
    this.size = Math.min(this.canvas.width / 1.25, this.canvas.height) / pixels;
  }
  /** How high letters are, in pixels of the canvas. */
  get letters() {
    return 14 * density();
  }
  /** Pixels of a point. */
  project() {
    const [r, u] = this.axes(),
      { width, height } = this.canvas,
      { scale, centre: [a, b, c] } = this;
    return (x, y, z) => {
      [x, y, z] = [x - a, y - b, z - c];
      const [right, up] = [r, u].map((row) => scale * (row[0] * x + row[1] * y + row[2] * z));
      return [width / 2 + right, height / 2 - up];
    };
  }
  /** The same for WebGL, so many pixels higher. */
  camera(higher = 0) {
    const rows = this.axes(),
      { width, height } = this.canvas,
      by = [(2 * this.scale) / width, (2 * this.scale) / height, -1 / (8 * this.size)],
      view = new Float32Array(16),
      turn = new Float32Array(9);
    rows.forEach((row, i) => {
      row.forEach((x, k) => {
        view[4 * k + i] = by[i] * x;
        view[12 + i] -= by[i] * x * this.centre[k];
        turn[3 * k + i] = x;
      });
    });
    view[13] += (2 * higher) / height;
    view[15] = 1;
    return { view, turn };
  }
  clear() {
    this.context.clearRect(0, 0, this.canvas.width, this.canvas.height);
    if (this.gl) this.solids.clear();
  }
  get solids() {
    return (this.made ??= new Solids(this.gl));
  }
  /** Triangles, where WebGL is. */
  solid(corners, indices, tint, higher) {
    if (this.gl) this.solids.draw(corners, indices, tint, this.camera(higher));
  }
  line(points, stroke, width = 2) {
    const { context } = this;
    context.strokeStyle = stroke;
    context.lineWidth = width * density();
    context.lineCap = context.lineJoin = "round";
    context.beginPath();
    points.forEach(([x, y], i) => (i ? context.lineTo(x, y) : context.moveTo(x, y)));
    context.stroke();
  }
  ring([x, y], radius, stroke) {
    const { context } = this;
    context.strokeStyle = stroke;
    context.lineWidth = 3 * density();
    context.beginPath();
    context.arc(x, y, radius * density(), 0, 7);
    context.stroke();
  }
  /** Words about a place, on a line. */
  words(text, x, y, tint) {
    const { context } = this;
    context.font = `600 ${this.letters}px system-ui, sans-serif`;
    context.textAlign = "center";
    context.fillStyle = tint;
    context.fillText(text, x, y);
  }
}
