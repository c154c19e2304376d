import load from "../package/dq8.js";
import loadRobots from "../package/robots.js";
import { between } from "./between.js";
import { crowd } from "./crowd.js";
import { bvh, glb } from "./files.js";
import { robot } from "./robot.js";
import { sleeve } from "./sleeve.js";
import { yours } from "./yours.js";

const section = (id) => document.getElementById(id), told = section("told"), state = (window.dq8 = {});
try {
  const [dq8, robots, urdf] = await Promise.all([load(), loadRobots(), fetch("../../robot/robots/arm7.urdf").then((answer) => answer.text())]);
  state.sleeve = sleeve(dq8, section("sleeve"));
  state.between = between(dq8, section("between"));
  state.robot = await robot(robots, section("robot"), urdf);
  state.yours = yours(dq8, section("yours"));
  state.crowd = crowd(dq8, section("crowd"));
  state.ready = true;
} catch (error) {
  told.className = "bad";
  told.textContent = `This browser cannot run dq8: ${error.message}`;
  throw error;
}

/** Plays a file; a bad one is told, and changes nothing. */
state.open = async (file) => {
  try {
    const kind = file.name.split(".").at(-1).toLowerCase();
    let what;
    if (kind === "urdf") { what = state.robot.show(new Uint8Array(await file.arrayBuffer())); section("robot").scrollIntoView(); }
    else if (kind === "bvh") what = state.yours.show(file.name, bvh(await file.text()));
    else if (kind === "glb") what = state.yours.show(file.name, glb(await file.arrayBuffer()));
    else throw new Error("none of .glb, .bvh, .urdf");
    told.className = "";
    told.textContent = `${file.name}: ${what}`;
  } catch (error) {
    told.className = "bad";
    told.textContent = `${file.name}: ${error.message}`;
    told.scrollIntoView({ block: "center" });
  }
};
section("file").addEventListener("change", ({ target }) => { for (const file of target.files) state.open(file); target.value = ""; });
addEventListener("dragover", (event) => { event.preventDefault(); document.body.classList.add("over"); });
addEventListener("dragleave", () => document.body.classList.remove("over"));
addEventListener("drop", (event) => { event.preventDefault(); document.body.classList.remove("over"); for (const file of event.dataTransfer.files) state.open(file); });
