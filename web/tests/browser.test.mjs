// A browser that has been closed leaves nothing.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { existsSync, mkdtempSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { removed } from "./browser.mjs";

test("a profile into which a child still writes is removed", async () => {
  const profile = mkdtempSync(join(tmpdir(), "dq8-profile-"));
  const writes = `const { existsSync, mkdirSync, writeFileSync } = require("node:fs");
    const fill = () => {
      if (!existsSync("${profile}/cache")) mkdirSync("${profile}/cache");
      for (let i = 0; i < 200; i++) writeFileSync("${profile}/cache/" + i, "x");
    };
    fill();
    process.send("writes");
    for (const end = Date.now() + 500; Date.now() < end; ) try { fill(); } catch {}`;
  const child = spawn(process.execPath, ["-e", writes], { stdio: ["ignore", "ignore", "ignore", "ipc"] }),
    ended = new Promise((end) => child.once("exit", end));
  await new Promise((begun) => child.once("message", begun));
  await Promise.all([removed(profile), ended]);
  assert.equal(existsSync(profile), false);
});
