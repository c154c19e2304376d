import { Rods } from "./gl.js";
import { end } from "./reading.js";
import { Scene, arrows, colour, dragged, escaped, rgb } from "./scene.js";

/** How far from its middle, in pixels, a finger takes hold of the ring. */
const GRIP = 44;
/** URDF has z up, the page y. */
const up = ([x, y, z]) => [x, z, -y];

function words({ outcome, linearError }) {
  const off = `${(1000 * linearError).toFixed(0)} mm`;
  return {
    converged: "The hand is there.",
    outOfReach: `Too far: the arm is stretched toward it, and ${off} are missing.`,
    atLimits: `Joints are at their limits: as near as they let it, ${off} away.`,
    stalled: `As near as it gets: ${off} away.`,
    unfinished: `Not there yet: ${off} away.`,
    invalid: "That is no place.",
  }[outcome];
}

/** The panel of a robot, which lives in the worker that has read its file; what moves it is asked of that. */
export function robot(section) {
  let made;
  const draw = () => {
    if (!made) return;
    const { places, parents, rods, hand, goal, thick, size } = made,
      at = places.map(up),
      project = scene.project();
    scene.clear();
    const [x, , z] = at[0],
      r = 0.25 * size,
      around = Array.from({ length: 65 }, (_, i) => (i * Math.PI) / 32);
    scene.line(around.map((a) => project(x + r * Math.cos(a), 0, z + r * Math.sin(a))), colour("--line"), 1);
    rods.set(parents.map((parent, j) => {
      const from = Math.max(parent, 0);
      return [at[from], at[j], size * thick[from], size * thick[j]];
    }));
    scene.solid(rods.corners, rods.indices, rgb("--b"));
    scene.ring(project(...up(goal)), 14, colour("--a"));
    scene.ring(project(...at[hand]), 3, colour("--a"));
  };
  const scene = new Scene(section, { yaw: 0.7, pitch: 0.25, orbit: false, draw }),
    state = { show, scene };
  const update = (aloud) => {
    const { report, hand, goal, places, asked } = made;
    Object.assign(state, { report, hand: places[hand], goal, asked });
    scene.tell(`<b>${words(report)}</b> ${report.iterations} steps`, aloud);
    scene.ask();
  };
  /** Asks for the way to the goal: to the last one, where the goal moves faster than the answers come. */
  function ask() {
    made.late = made.asked;
    if (!made.asked) made.worker.postMessage(made.goal);
    made.asked = true;
  }
  function show(name, next) {
    if (made) end(made.worker);
    made = next;
    made.rods = new Rods(made.parents.length);
    const answered = ({ data }) => {
      Object.assign(made, data, { asked: false });
      if (made.late) ask();
      update(true);
    };
    made.worker.onmessage = answered;
    made.worker.onerror = (event) => {
      answered(event);
      scene.tell(escaped(event.message), true);
    };
    const { values, warnings, parents, size, centre } = made;
    Object.assign(scene, { size, centre: up(centre) });
    section.querySelector(".of").textContent = `${values} joints of ${name}`;
    update(false);
    const more = warnings ? `; ${warnings} things in it are not read` : "";
    return `${parents.length} links, ${values} values${more}`;
  }
  /** By pixels right and down, in the plane of the screen, and toward the viewer. */
  function drag(right, down, near = 0) {
    if (!made) return;
    const { canvas } = scene,
      scale = canvas.width / canvas.clientWidth / scene.scale,
      [r, u, f] = scene.axes(),
      by = [0, 1, 2].map((k) => scale * (right * r[k] - down * u[k] + near * f[k])),
      [x, y, z] = made.goal;
    made.goal = [x + by[0], y - by[2], z + by[1]];
    ask();
    update(false);
  }
  /** A finger on the ring drags it; elsewhere it scrolls. */
  const grips = ({ clientX, clientY }) => {
    if (!made) return false;
    const { left, top, width } = scene.canvas.getBoundingClientRect(),
      pixels = scene.canvas.width / width,
      [x, y] = scene.project()(...up(made.goal));
    return Math.hypot(clientX - left - x / pixels, clientY - top - y / pixels) < GRIP;
  };
  const hold = (event) => grips(event.touches[0]) && event.preventDefault();
  scene.canvas.addEventListener("touchstart", hold, { passive: false });
  dragged(scene.canvas, drag, grips);
  arrows(scene.canvas, (right, down, shift) => (shift ? drag(0, 0, 12 * down) : drag(12 * right, 12 * down)));
  return state;
}
