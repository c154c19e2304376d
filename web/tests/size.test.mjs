// What a page waits for: the modules as servers compress them, in bytes, 1,000 to a kilobyte.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { brotliCompressSync, constants } from "node:zlib";

const MOST = { core: 75_000, both: 185_000 };

test(`the core is at most ${MOST.core} bytes, with robots ${MOST.both}; they import nothing`, (t) => {
  const [core, robots] = ["dq8", "robots"].map((name) => {
    const wasm = readFileSync(new URL(`../package/${name}.simd128.wasm`, import.meta.url));
    assert.equal(WebAssembly.Module.imports(new WebAssembly.Module(wasm)).length, 0);
    return brotliCompressSync(wasm, { params: { [constants.BROTLI_PARAM_QUALITY]: 11, [constants.BROTLI_PARAM_SIZE_HINT]: wasm.length } }).length;
  });
  t.diagnostic(`${core} and ${robots} bytes`);
  assert.ok(core <= MOST.core && core + robots <= MOST.both, `${core} and ${robots} bytes`);
});
