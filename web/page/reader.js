// The worker that reads a file, so that the page goes on. It answers with { part }, { made } or
// { error }.
import { bvh, glb } from "./files.js";

const READERS = {
  bvh: async (file, progress) => bvh(await file.text(), progress),
  glb: async (file) => glb(await file.arrayBuffer()),
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
