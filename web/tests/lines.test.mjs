// Sizes are counted on what ships, so lines of source may be as long as is good to read, and no longer.
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { test } from "node:test";

const MOST = 120;

test(`lines have at most ${MOST} characters`, () => {
  for (const folder of ["package", "bundlers", "page", "tests", "bench", "engines"]) {
    for (const name of readdirSync(new URL(`../${folder}`, import.meta.url))) {
      if (!/\.(m?js|m?ts|html)$/.test(name)) continue;
      const lines = readFileSync(new URL(`../${folder}/${name}`, import.meta.url), "utf8").split("\n");
      const long = lines.findIndex((line) => line.length > MOST);
      assert.equal(long, -1, `${folder}/${name}:${long + 1}`);
    }
  }
});
