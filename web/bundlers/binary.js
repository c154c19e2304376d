// The files as bytes in the bundle.
import wasm from "dq8/dq8.simd128.wasm";
import robots from "dq8/robots.simd128.wasm";
import { answer } from "./app.js";

answer({ wasm }, { wasm: robots }).then(
  (text) => {
    globalThis.answer = text;
  },
  (error) => {
    globalThis.answer = String(error);
  },
);
