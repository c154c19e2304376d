// In the shell of JavaScriptCore, which has no page and no node around it: jsc -m bench/jsc.mjs, from the folder above.
/** What the package and its peers take from pages, by the names of the shell's own functions. */
class Decoder {
  decode(bytes) {
    const text = Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
    return decodeURIComponent(escape(text));
  }
}
class Encoder {
  encode(text) {
    return Uint8Array.from(unescape(encodeURIComponent(text)), (c) => c.charCodeAt(0));
  }
}
Object.assign(globalThis, { TextDecoder: Decoder, TextEncoder: Encoder });
globalThis.performance ??= { now: () => 1000 * preciseTime() };
globalThis.console ??= { log: print, warn: print, error: print };

const [{ default: load }, { default: loadRobots }, THREE, glMatrix, { run }] = await Promise.all(
  [
    "../package/dq8.js",
    "../package/robots.js",
    "./node_modules/three/build/three.module.js",
    "./node_modules/gl-matrix/esm/index.js",
    "./jobs.mjs",
  ].map((path) => import(path)),
);
const file = (name) => read(`package/${name}.simd128.wasm`, "binary");
await run({
  load: () => load({ wasm: file("dq8") }),
  loadRobots: () => loadRobots({ wasm: file("robots") }),
  THREE,
  glMatrix,
  urdf: read("../robot/robots/arm7.urdf"),
  levels: ["simd128"],
  log: print,
});
