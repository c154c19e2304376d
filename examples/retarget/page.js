"use strict";
// `motion` has figures; each has `bones` from point to point, with the side of the body, the points
// of both `soles`, and `rows` of millimetres: what a frame adds to the frame before it.
const motion = JSON.parse(document.getElementById("motion").textContent);
const [canvas, play, slider, speed, time] = ["canvas", "#play", "#frame", "#speed", "#time"].map((name) =>
  document.querySelector(name),
);
const pen = canvas.getContext("2d"),
  last = motion.frames - 1;
for (const figure of motion.figures) {
  let sum = figure.rows[0].map(() => 0);
  figure.places = figure.rows.map((row) => (sum = sum.map((x, k) => x + row[k])));
}
document.title = motion.title;
document.querySelector("h1").textContent = motion.title;
for (const words of motion.measures) {
  const row = document.querySelector("table").insertRow();
  for (const word of words) row.insertCell().textContent = word;
}
slider.max = last;

const view = { yaw: 0.7, pitch: 0.25, zoom: 1 };
let now = 0,
  plays = last > 0,
  before;

/** Leads places to the screen: a half of the canvas, seen by an eye that keeps beside the root. */
function camera(places, left, width, height) {
  const [c, s, up, away] = [Math.cos(view.yaw), Math.sin(view.yaw), Math.cos(view.pitch), Math.sin(view.pitch)],
    scale = (0.7 * view.zoom * Math.min(height, 1.3 * width)) / motion.height;
  return ([x, y, z]) => {
    [x, y, z] = [x - places[0], y - motion.height / 2, z - places[2]];
    const [right, near] = [c * x - s * z, s * x + c * z];
    return [left + width / 2 + scale * right, height / 2 - scale * (up * y - away * near)];
  };
}

function line(points) {
  pen.beginPath();
  for (const [x, y] of points) pen.lineTo(x, y);
  pen.stroke();
}

/** Squares of half a metre on the ground around the root. */
function ground(to, [x, , z], colour) {
  const [step, reach] = [500, 4],
    [i, k] = [Math.round(x / step), Math.round(z / step)];
  [pen.strokeStyle, pen.lineWidth] = [colour, 1];
  for (let n = -reach; n <= reach; n++) {
    line([[i + n, k - reach], [i + n, k + reach]].map(([a, b]) => to([a * step, 0, b * step])));
    line([[i - reach, k + n], [i + reach, k + n]].map(([a, b]) => to([a * step, 0, b * step])));
  }
}

function draw() {
  const sharp = window.devicePixelRatio || 1,
    { clientWidth: width, clientHeight: height } = canvas;
  [canvas.width, canvas.height] = [width * sharp, height * sharp];
  pen.scale(sharp, sharp);
  [pen.lineCap, pen.lineJoin, pen.font] = ["round", "round", "15px sans-serif"];
  const style = getComputedStyle(document.body),
    colour = (name) => style.getPropertyValue(`--${name}`),
    frame = Math.floor(now);
  motion.figures.forEach((figure, index) => {
    const places = figure.places[frame],
      left = (index * width) / 2,
      onto = camera(places, left, width / 2, height),
      at = (point) => onto(places.slice(3 * point, 3 * point + 3));
    pen.save();
    pen.beginPath();
    pen.rect(left, 0, width / 2, height);
    pen.clip();
    ground(onto, places, colour("faint"));
    figure.soles.forEach((sole, foot) => {
      if (!sole.length) return;
      const corners = sole.map(at);
      const stands = motion.stands[foot][frame] === "1";
      pen.strokeStyle = pen.fillStyle = colour(["left", "right"][foot]);
      [pen.lineWidth, pen.globalAlpha] = stands ? [9, 1] : [2, 0.6];
      pen.beginPath();
      for (const [x, y] of corners) pen.lineTo(x, y);
      pen.closePath();
      pen.stroke();
      if (stands) pen.fill();
      pen.globalAlpha = 1;
    });
    pen.lineWidth = 4;
    for (const [from, to, side] of figure.bones) {
      pen.strokeStyle = colour(side);
      line([at(from), at(to)]);
    }
    pen.fillStyle = colour("text");
    pen.fillText(figure.caption, left + 12, 24);
    pen.restore();
  });
  slider.value = frame;
  time.textContent = `frame ${frame} of ${last}, ${(frame * motion.step).toFixed(2)} s`;
  play.textContent = plays ? "Pause" : "Play";
}

function tick(clock) {
  if (plays && before !== undefined) {
    now += ((clock - before) / 1000 / motion.step) * Number(speed.value);
    if (now >= motion.frames) now %= motion.frames;
  }
  before = clock;
  draw();
  requestAnimationFrame(tick);
}

function go(frame) {
  plays = false;
  now = Math.max(0, Math.min(last, frame));
}
function toggle() {
  plays = !plays;
}
play.onclick = toggle;
slider.oninput = () => go(Number(slider.value));
document.onkeydown = (event) => {
  const keys = { ArrowLeft: () => go(Math.floor(now) - 1), ArrowRight: () => go(Math.floor(now) + 1), " ": toggle };
  if (event.target.closest("select, button") || !keys[event.key]) return;
  event.preventDefault();
  keys[event.key]();
};
canvas.onpointerdown = (event) => canvas.setPointerCapture(event.pointerId);
canvas.onpointermove = (event) => {
  if (!event.buttons) return;
  view.yaw -= event.movementX / 150;
  view.pitch = Math.max(-0.2, Math.min(1.5, view.pitch + event.movementY / 150));
};
canvas.addEventListener("wheel", (event) => {
  event.preventDefault();
  view.zoom = Math.max(0.2, Math.min(8, view.zoom * Math.exp(-event.deltaY / 500)));
}, { passive: false });
requestAnimationFrame(tick);
