// Files that are chosen or dropped: they are read in a worker, with a bar, and can be given up.
import { end, read } from "./reading.js";

const section = (id) => document.getElementById(id),
  told = section("told"),
  reading = section("reading"),
  bar = reading.querySelector("progress");
/** So soon, in milliseconds, no bar is shown. */
const SOON = 150;
const KINDS = /\.(glb|bvh|urdf)$/i;
let giveUp;

function tell(text, bad) {
  told.className = bad ? "bad" : "";
  told.textContent = text;
}

/** What a worker makes of a file, with a bar; undefined if it is given up, by its reader or by a next file. */
function shown(kind, file) {
  const { worker, made } = read(kind, file, (part) => (bar.value = part)),
    later = setTimeout(() => (reading.hidden = false), SOON);
  bar.removeAttribute("value");
  reading.querySelector("span").textContent = `Reading ${file.name}`;
  const hide = () => {
    clearTimeout(later);
    reading.hidden = true;
    giveUp = undefined;
  };
  const given = new Promise((resolve) => {
    giveUp = () => {
      hide();
      end(worker);
      tell(`${file.name}: given up`);
      resolve();
    };
  });
  return Promise.race([given, made.finally(hide)]);
}

/** Plays files; a bad one is told, and changes nothing. */
export function opening(robot, yours) {
  /** Of several files, the first that is played here. */
  function open(files) {
    const file = files.find(({ name }) => KINDS.test(name)) ?? files[0],
      others = files.filter((other) => other !== file).map(({ name }) => name);
    if (file) play(file, others.length ? `; one file is taken at a time, so not ${others.join(", ")}` : "");
  }
  async function play(file, more) {
    giveUp?.();
    try {
      const kind = file.name.split(".").pop().toLowerCase();
      if (!KINDS.test(file.name)) {
        const hint = kind === "gltf" ? "; a .glb has in one file what a .gltf has in several" : "";
        throw new Error(`none of .glb, .bvh, .urdf${hint}`);
      }
      const made = await shown(kind, file);
      if (!made) return;
      if (kind === "urdf") section("robot").scrollIntoView();
      else end(made.worker);
      const what = (kind === "urdf" ? robot : yours).show(file.name, made);
      tell(`${file.name}: ${what}${more}`);
    } catch (error) {
      tell(`${file.name}: ${error.message}${more}`, true);
      told.scrollIntoView({ block: "center" });
    }
  }
  reading.querySelector("button").addEventListener("click", () => giveUp?.());
  section("file").addEventListener("change", ({ target }) => {
    open([...target.files]);
    target.value = "";
  });
  addEventListener("dragover", (event) => {
    event.preventDefault();
    document.body.classList.add("over");
  });
  addEventListener("dragleave", () => document.body.classList.remove("over"));
  addEventListener("drop", (event) => {
    event.preventDefault();
    document.body.classList.remove("over");
    open([...event.dataTransfer.files]);
  });
}
