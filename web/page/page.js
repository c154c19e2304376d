import load from "../package/dq8.js";
import loadRobots from "../package/robots.js";
import { between } from "./between.js";
import { crowd } from "./crowd.js";
import { opening } from "./opening.js";
import { robot } from "./robot.js";
import { sleeve } from "./sleeve.js";
import { yours } from "./yours.js";

const section = (id) => document.getElementById(id),
  state = (window.dq8 = {}),
  arm = fetch("../../robot/robots/arm7.urdf").then((answer) => answer.text());
try {
  const [dq8, robots, urdf] = await Promise.all([load(), loadRobots(), arm]);
  state.crowd = crowd(dq8, section("crowd"));
  state.sleeve = sleeve(dq8, section("sleeve"));
  state.robot = robot(robots, section("robot"), urdf);
  state.between = between(dq8, section("between"));
  state.yours = yours(dq8, section("yours"));
  opening(state.robot, state.yours);
  state.ready = true;
} catch (error) {
  const told = section("told");
  told.className = "bad";
  told.textContent = `This browser cannot run dq8: ${error.message}`;
  throw error;
}
