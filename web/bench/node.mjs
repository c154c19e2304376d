// In node, by the time of the CPU, which others on the machine do not lengthen: node bench/node.mjs [LEVEL…]
import { readFileSync } from "node:fs";
import * as glMatrix from "gl-matrix";
import * as THREE from "three";
import load from "../package/dq8.node.js";
import loadRobots from "../package/robots.node.js";
import { run } from "./jobs.mjs";

const levels = process.argv.length > 2 ? process.argv.slice(2) : ["simd128"],
  quick = process.env.QUICK;
const urdf = readFileSync(new URL("../../robot/robots/arm7.urdf", import.meta.url), "utf8");
const clock = () => {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1000;
};
console.log(`node ${process.version}`);
await run({
  load,
  loadRobots,
  THREE,
  glMatrix: glMatrix.default ?? glMatrix,
  urdf,
  levels,
  clock,
  ...(quick ? { instances: 40, people: 4, seconds: 0 } : {}),
});
