// The lines of the package's README, copied into files of a project that has installed it, and run.
import assert from "node:assert/strict";
import { cpSync, existsSync, readFileSync, writeFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { join } from "node:path";
import { TOOLS, project, run } from "./packed.mjs";

const README = readFileSync(new URL("../package/README.md", import.meta.url), "utf8");
const blocks = [...README.matchAll(/^```js\n([^]*?)^```/gm)].map(([, block]) => block);
/** What the reader has. */
const GIVEN = `import { readFileSync } from "node:fs";
const urdf = readFileSync("arm7.urdf", "utf8"), times = Float32Array.from({ length: 1000 }, (_, i) => i / 999);
const keys = new Float32Array(3 * 31 * 7);
for (let key = 0; key < keys.length; key += 7) keys.set([0, 0, 0, 1, Math.floor(key / 21) / 30, 0, 0], key);
`;
/** What must be true after a block, by a word in it. */
const TRUE = [
  // At second t of 1, the third joint of a chain is three times t away.
  [
    "walk.sample",
    `for (const person of [0, 500, 999]) {
      const x = palette.view[16 * (3 * person + 2) + 12];
      if (Math.abs(x - 3 * (times[person] % 1)) > 1e-5) throw new Error("person " + person);
    }`,
  ],
  [
    "robot.reach",
    'if (outcome !== "converged" || !(linearError < 1e-3)) throw new Error(`${outcome} ${linearError}`);',
  ],
  [
    "DataTexture",
    `const { data, width, height } = texture.image;
    if (data.length !== 4 * width * height || texture.version < 1) throw new Error("texture");`,
  ],
  ["compile()", 'if (other.motions(1).view[3] !== 1) throw new Error("worker");'],
  ["wasm from", 'if (packed.motions(1).view[3] !== 1) throw new Error("packed");'],
  ["fallback", 'if (quick.motions(1).view[3] !== 1) throw new Error("relaxed");'],
];

let folder, files, remove;
before(() => {
  ({ folder, files, remove } = project());
});
after(() => remove?.());

test("all lines of the README run, and do what it says", async (t) => {
  assert.equal(blocks.length, TRUE.length);
  const [three, relaxed] = [existsSync(join(TOOLS, "three")), files.includes("dq8.relaxed.wasm")];
  const parts = TRUE.flatMap(([word, check]) => {
    const block = blocks.find((block) => block.includes(word));
    assert.ok(block, word);
    if ((word === "DataTexture" && !three) || (word === "fallback" && !relaxed)) {
      t.diagnostic(`without ${word}`);
      return [];
    }
    return [block, check];
  });
  cpSync(new URL("../../robot/robots/arm7.urdf", import.meta.url), join(folder, "arm7.urdf"));
  writeFileSync(join(folder, "readme.js"), GIVEN + parts.join("\n"));
  const { build } = await import(join(TOOLS, "esbuild/lib/main.js"));
  await build({
    absWorkingDir: folder,
    entryPoints: ["readme.js"],
    bundle: true,
    platform: "node",
    target: "es2022",
    format: "esm",
    outfile: join(folder, "readme.bundle.mjs"),
    loader: { ".wasm": "binary" },
    logLevel: "error",
  });
  for (const name of files.filter((name) => name.endsWith(".wasm")))
    cpSync(join(folder, "node_modules/dq8", name), join(folder, name));
  run("node", ["readme.bundle.mjs"], { cwd: folder });
});

test("the README is one screen of lines that a terminal holds", () => {
  const lines = README.split("\n");
  assert.ok(lines.length <= 100, `${lines.length} lines`);
  for (const line of lines) assert.ok(line.length <= 120, line);
});
