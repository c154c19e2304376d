import load from "../package/dq8.js";
import { between } from "./between.js";
import { crowd } from "./crowd.js";
import { opening } from "./opening.js";
import { end, read } from "./reading.js";
import { robot } from "./robot.js";
import { escaped } from "./scene.js";
import { sleeve } from "./sleeve.js";
import { yours } from "./yours.js";

const section = (id) => document.getElementById(id),
  state = (window.dq8 = {}),
  arm = fetch("../../robot/robots/arm7.urdf").then(async (answer) => read("urdf", await answer.blob()).made);
try {
  const dq8 = await load();
  state.crowd = crowd(dq8, section("crowd"));
  state.sleeve = sleeve(dq8, section("sleeve"));
  state.robot = robot(section("robot"));
  state.between = between(dq8, section("between"));
  state.yours = yours(dq8, section("yours"));
  opening(state.robot, state.yours);
  // Without an arm the rest goes on; where a file has brought a robot before, that stays.
  await arm.then(
    (it) => (state.robot.goal ? end(it.worker) : state.robot.show("an arm", it)),
    ({ message }) => state.robot.goal || state.robot.scene.tell(escaped(message)),
  );
  state.ready = true;
} catch (error) {
  const told = section("told");
  told.className = "bad";
  told.textContent = `This browser cannot run dq8: ${error.message}`;
  throw error;
}
