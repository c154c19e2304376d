// What a page waits for, as servers compress it, in bytes, 1,000 to a kilobyte: modules, and the scripts that load
// them.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { brotliCompressSync, constants } from "node:zlib";

const MOST = { core: 75_000, both: 185_000, pack: 15_000 };
const SHARED = ["engine.js", "memory.js", "arrays.js", "loud.js"];
const read = (name) => readFileSync(new URL(`../package/${name}`, import.meta.url));
/** As a bundler joins scripts: without comments and indentation. */
const joined = (names) => Buffer.from(names.map((name) => read(name).toString()
  .replace(/^\s*(\/\/.*|\/\*\*[^]*?\*\/)$/gm, "").replace(/^\s+/gm, "")).join("\n"));
const compressed = (bytes) => brotliCompressSync(bytes, {
  params: { [constants.BROTLI_PARAM_QUALITY]: 11, [constants.BROTLI_PARAM_SIZE_HINT]: bytes.length },
}).length;

test(`the core is at most ${MOST.core} bytes, with robots ${MOST.both}; they import nothing`, (t) => {
  const [core, robots] = ["dq8", "robots"].map((name) => {
    const wasm = read(`${name}.simd128.wasm`);
    assert.equal(WebAssembly.Module.imports(new WebAssembly.Module(wasm)).length, 0);
    return compressed(wasm);
  });
  const [shared, dq8, arms] = [SHARED, ["dq8.js", "sampled.js"], ["robots.js"]]
    .map((names) => compressed(joined(names)));
  t.diagnostic(`modules of ${core} and ${robots} bytes, scripts of ${shared + dq8} and ${arms}`);
  const page = core + shared + dq8, both = page + robots + arms;
  assert.ok(page <= MOST.core && both <= MOST.both, `${page} and ${both} bytes`);
});

test(`packing is at most ${MOST.pack} bytes, which no other page waits for`, (t) => {
  const wasm = read("pack.simd128.wasm");
  assert.equal(WebAssembly.Module.imports(new WebAssembly.Module(wasm)).length, 0);
  const [module, scripts] = [compressed(wasm), compressed(joined(["pack.js"]))];
  t.diagnostic(`a module of ${module} bytes, a script of ${scripts}`);
  assert.ok(module + scripts <= MOST.pack, `${module + scripts} bytes`);
  for (const name of ["dq8.js", "robots.js", ...SHARED]) assert.doesNotMatch(read(name).toString(), /\bpack\.js/);
});
