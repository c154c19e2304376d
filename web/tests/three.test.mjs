// The example for three.js in Chromium: its palettes are those of three.js' own bones, and what is drawn is what
// they draw.
import assert from "node:assert/strict";
import { mkdirSync, writeFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { open } from "./browser.mjs";
import { serve } from "./server.mjs";

let server, browser, page;
before(async () => {
  [server, browser] = [await serve(), await open()];
  page = await browser.page(`${server.url}/web/examples/three/index.html`, { width: 800, height: 500 });
  await page.until("window.ready");
});
after(async () => {
  await browser?.close();
  server?.close();
});

test("a thousand characters have the palettes of three.js", async (t) => {
  for (const seconds of [0, 0.3, 7.77]) {
    const difference = await page.evaluate(`difference(${seconds})`);
    t.diagnostic(`${difference}`);
    assert.ok(difference < 1e-5, `at ${seconds} s: ${difference}`);
  }
});

test("one of them covers the pixels that three.js covers", async (t) => {
  for (const person of [3, 700]) {
    const { differ, covered } = await page.evaluate(`pixels(${person}, 0.4)`);
    t.diagnostic(`${differ} of ${covered}`);
    assert.ok(covered > 1500 && differ < covered / 200, `${differ} of ${covered}`);
  }
});

test("all of them are drawn, and nothing is said to the console", async () => {
  const picture = await page.screenshot();
  mkdirSync(new URL("../target/", import.meta.url), { recursive: true });
  writeFileSync(new URL("../target/three.png", import.meta.url), picture);
  assert.ok(picture.length > 30000, `${picture.length} bytes`);
  assert.deepEqual(page.messages, []);
});
