// The files as bytes in the bundle.
import wasm from "dq8/dq8.simd128.wasm";
import pack from "dq8/pack.simd128.wasm";
import robots from "dq8/robots.simd128.wasm";
import { answer } from "./app.js";

answer({ wasm }, { wasm: robots }, { wasm: pack }).then(
  (text) => {
    globalThis.answer = text;
  },
  (error) => {
    globalThis.answer = String(error);
  },
);
