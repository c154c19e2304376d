// What all bundlers are given: all modules of the package, with answers that can be told from wrong ones.
import load, { LevelError, supports } from "dq8";
import loadPacker from "dq8/pack";
import loadRobots from "dq8/robots";

const URDF = `<robot name="door"><link name="frame"/><link name="leaf"/><joint name="hinge" type="revolute">
  <parent link="frame"/><child link="leaf"/><origin xyz="1 2 3"/><axis xyz="0 0 1"/>
  <limit lower="-1" upper="1" effort="1" velocity="1"/></joint></robot>`;

/**
 * "3 6 9 | frame leaf | 1 2 3 | 1.5": translations along a chain, the links of a robot, where the second hangs, and
 * where a packed clip is in the middle.
 */
export async function answer(options = {}, robotOptions = {}, packOptions = {}) {
  if (!supports("simd128")) throw new LevelError("simd128");
  const dq8 = await load(options),
    robots = await loadRobots(robotOptions),
    packer = await loadPacker(packOptions);
  const locals = dq8.motions(3),
    skeleton = dq8.skeleton([-1, 0, 1]),
    matrices = dq8.floats(48);
  for (let joint = 0; joint < 3; joint++) locals.view[8 * joint + 4] = 1.5;
  skeleton.localToModel(locals);
  dq8.matrices(locals, matrices);
  const robot = robots.robot(URDF),
    poses = robots.floats(16);
  robot.poses(robots.floats([0]), poses);
  const translations = [0, 1, 2].map((joint) => matrices.view[16 * joint + 12]);
  const keys = [0, 3].flatMap((x) => [0, 0, 0, 1, x, 0, 0]),
    packed = dq8.packedClip(packer.pack(1, [{ keys }])),
    middle = dq8.motions(1);
  dq8.skeleton([-1]).locals(packed.sample(0.5), middle);
  const x = (2 * middle.view[4]).toFixed(1);
  return [translations, robot.linkNames, [...poses.view.subarray(12, 15)].map((half) => 2 * half), [x]]
    .map((part) => part.join(" "))
    .join(" | ");
}
