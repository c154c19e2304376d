// The worker that reads a file, so that the page goes on. It answers with { part }, { made } or
// { error }. That of a robot stays, and answers goals with what `aim` gives.
import { bvh, glb } from "./files.js";

const READERS = {
  bvh: async (file, progress) => bvh(await file.text(), progress),
  glb: async (file) => glb(await file.arrayBuffer()),
  urdf: async (file) => {
    const { arm } = await import("./arm.js"),
      { made, aim } = await arm(file);
    onmessage = ({ data: goal }) => postMessage(aim(goal));
    return made;
  },
};

onmessage = async ({ data: { kind, file } }) => {
  try {
    const made = await READERS[kind](file, (part) => postMessage({ part })),
      arrays = [made.keys, ...Object.values(made.mesh ?? {})].filter(ArrayBuffer.isView);
    postMessage({ made }, [...new Set(arrays.map(({ buffer }) => buffer))]);
  } catch (error) {
    postMessage({ error: error.message });
  }
};
