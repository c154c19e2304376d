// Files that are chosen or dropped: they are read in a worker, with a bar, and can be given up.

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

/** What a worker makes of a file; undefined if it is given up, by its reader or by a next file. */
function read(kind, file) {
  return new Promise((resolve, reject) => {
    const worker = new Worker(new URL("reader.js", import.meta.url), { type: "module" }),
      shown = setTimeout(() => (reading.hidden = false), SOON);
    let answers = false;
    const end = () => {
      clearTimeout(shown);
      worker.terminate();
      reading.hidden = true;
      giveUp = undefined;
    };
    giveUp = () => {
      end();
      resolve();
    };
    bar.removeAttribute("value");
    reading.querySelector("span").textContent = `Reading ${file.name}`;
    worker.onmessage = ({ data: { part, made, error } }) => {
      answers = true;
      if (part !== undefined) return void (bar.value = part);
      end();
      if (made) resolve(made);
      else reject(new Error(error));
    };
    worker.onerror = ({ message = "no reason is known" }) => {
      end();
      const why = answers ? "its reader failed" : "its reader, a worker that is a module, does not start";
      reject(new Error(`${why}${answers ? "" : ", as in browsers before 2023"}: ${message}`));
    };
    worker.postMessage({ kind, file });
  });
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
      const kind = /\.(\w+)$/.exec(file.name)?.[1].toLowerCase();
      let what;
      if (kind === "urdf") {
        what = robot.show(file.name, new Uint8Array(await file.arrayBuffer()));
        section("robot").scrollIntoView();
      } else if (kind === "bvh" || kind === "glb") {
        const made = await read(kind, file);
        if (!made) return tell(`${file.name}: given up`);
        what = yours.show(file.name, made);
      } else {
        const hint = kind === "gltf" ? "; a .glb has in one file what a .gltf has in several" : "";
        throw new Error(`none of .glb, .bvh, .urdf${hint}`);
      }
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
