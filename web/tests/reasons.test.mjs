// Why dq8 does not start: an engine without a level, a file that is none, a page that is opened as a file. The bundles
// of `bundlers` have the missing files and the content policies.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import load, { LevelError, compile, supports } from "../package/dq8.node.js";
import loadInBrowsers from "../package/dq8.js";
import relaxed from "../package/relaxed.js";
import robotsRelaxed from "../package/robots-relaxed.js";
import loadRobots from "../package/robots.node.js";
import { open } from "./browser.mjs";
import { serve } from "./server.mjs";

/** Runs while the engine lacks the levels whose probes `lacks` says are too long for it. */
async function without(lacks, run) {
  const { validate } = WebAssembly;
  WebAssembly.validate = (bytes) => !lacks(bytes.length) && validate(bytes);
  try {
    return await run();
  } finally {
    WebAssembly.validate = validate;
  }
}
const fails = (promise, name, message) =>
  assert.rejects(promise, (error) => {
    assert.equal(error.name, name);
    assert.match(error.message, message);
    return true;
  });
const isRelaxed = (length) => length > 30 && length < 60,
  isProbe = (length) => length < 60;

test("an engine without relaxed SIMD throws LevelError, and simd128 stands in where that is wanted", () =>
  without(isRelaxed, async () => {
    assert.deepEqual([supports("simd128"), supports("relaxed")], [true, false]);
    await fails(load({ level: relaxed }), "LevelError", /^this engine has no relaxed SIMD in WebAssembly/);
    await assert.rejects(load({ level: relaxed }), (error) => error instanceof LevelError && error.level === "relaxed");
    assert.equal((await load({ level: relaxed, fallback: true })).motions(1).view[3], 1);
    assert.equal((await loadRobots({ level: robotsRelaxed, fallback: true })).floats([2]).view[0], 2);
  }));

test("an engine without SIMD throws LevelError, with a fallback too", () =>
  without(isProbe, async () => {
    assert.deepEqual([supports("simd128"), supports("relaxed")], [false, false]);
    await fails(load(), "LevelError", /^this engine has no SIMD in WebAssembly, which Chrome has since 91/);
    await fails(load({ level: relaxed, fallback: true }), "LevelError", /no SIMD/);
  }));

test("levels are those of the module, and imported", async () => {
  await fails(
    load({ level: "avx512" }),
    "RangeError",
    /^level is avx512, neither "simd128" nor what dq8\/relaxed exports$/,
  );
  await fails(load({ level: "relaxed" }), "RangeError", /^level is relaxed, neither .* what dq8\/relaxed exports$/);
  await fails(load({ level: robotsRelaxed }), "RangeError", /^level is relaxed of dq8\/robots, neither/);
  await fails(loadRobots({ level: relaxed }), "RangeError", /what dq8\/robots-relaxed exports$/);
  assert.throws(() => supports("avx512"), /^RangeError: level is avx512, none of simd128, relaxed$/);
});

test("bytes that are no module, and files that browsers do not read, are told", async () => {
  await fails(
    load({ wasm: new TextEncoder().encode("<!doctype html>") }),
    "Error",
    /^wasm: this is no WebAssembly; servers answer so/,
  );
  await fails(
    load({ wasm: Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0, 9) }),
    "Error",
    /^wasm: WebAssembly\.compile\(\)/,
  );
  await fails(load({ wasm: "dq8.wasm" }), "TypeError", /^wasm is neither an ArrayBuffer/);
  await fails(
    loadInBrowsers(),
    "Error",
    /dq8\.simd128\.wasm cannot be fetched: pages that are opened as files may read none/,
  );
  const [one, other] = await Promise.all([1, 2].map(async () => load({ wasm: await compile() })));
  assert.notEqual(one.floats(1).view.buffer, other.floats(1).view.buffer, "each has its own memory");
});

describe("the page says so", () => {
  let server, browser;
  before(async () => {
    [server, browser] = await Promise.all([serve(), open()]);
  });
  after(async () => {
    await browser?.close();
    server?.close();
  });
  const told = async (url, prepare) =>
    (await browser.page(url, { before: prepare })).until(`document.getElementById("told")?.textContent`);
  const served = () => `${server.url}/web/page/index.html`;

  test("without SIMD", async () => {
    assert.match(
      await told(served(), "WebAssembly.validate = () => false"),
      /^This browser cannot run dq8: this engine has no SIMD/,
    );
  });
  test("without WebAssembly", async () => {
    assert.match(
      await told(served(), "delete globalThis.WebAssembly"),
      /^This browser cannot run dq8: this engine has no WebAssembly$/,
    );
  });
  test("opened as a file", async () => {
    const file = new URL("../page/index.html", import.meta.url).href;
    assert.match(
      await told(file),
      /^Browsers load no modules into pages that are opened as files\. Serve them: node web/,
    );
  });
});
