// What a page waits for: the modules as servers compress them.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { brotliCompressSync, constants } from "node:zlib";

for (const [name, most] of [["dq8", 65], ["robots", 100]]) test(`${name} is at most ${most} KB`, (t) => {
  const wasm = readFileSync(new URL(`../package/${name}.simd128.wasm`, import.meta.url));
  const { length } = brotliCompressSync(wasm, { params: { [constants.BROTLI_PARAM_QUALITY]: 11, [constants.BROTLI_PARAM_SIZE_HINT]: wasm.length } });
  t.diagnostic(`${length} bytes`);
  assert.ok(length <= most * 1024, `${length} bytes`);
  assert.equal(WebAssembly.Module.imports(new WebAssembly.Module(wasm)).length, 0, "it imports nothing");
});
