// The same in a browser that nobody drives: it opens the page, which posts its answer. node bench/browser.mjs NAME, of
// those in `BROWSERS`; their programs are Debian's.
import { spawn } from "node:child_process";
import { mkdtempSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { removed } from "../tests/browser.mjs";
import { serve } from "../tests/server.mjs";

const MINUTES = 5;
const profile = mkdtempSync(join(tmpdir(), "dq8-browser-"));
const BROWSERS = {
  firefox: ["firefox-esr", "--headless", "--no-remote", "--profile", profile],
  // WebKitGTK's own browser has no mode without a screen; its sandbox wants rights that containers lack.
  webkit: ["xvfb-run", "-a", "/usr/lib/x86_64-linux-gnu/webkit2gtk-4.1/MiniBrowser", "--private"],
};
const [program, ...args] = BROWSERS[process.argv[2]] ?? [];
if (!program) throw new Error(`no such browser: ${process.argv[2]}; ${Object.keys(BROWSERS).join(" and ")} are`);

const extra = { "/node_modules": new URL("node_modules", import.meta.url).pathname };
const server = await serve(0, { isolated: true, extra });
let answered, browser;
const answer = new Promise((resolve) => (answered = resolve));
const post = createServer(async (request, reply) => {
  let body = "";
  for await (const part of request) body += part;
  reply.end();
  if (request.method === "POST") answered(body);
});
await new Promise((listening) => post.listen(0, "127.0.0.1", listening));
try {
  const to = encodeURIComponent(`http://127.0.0.1:${post.address().port}/`);
  const env = {
    ...process.env,
    HOME: profile,
    WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS: "1",
    LIBGL_ALWAYS_SOFTWARE: "1",
  };
  // A group of its own, whose processes end together.
  browser = spawn(program, [...args, `${server.url}/web/bench/index.html?to=${to}`], {
    env,
    detached: true,
    stdio: "ignore",
  });
  const late = new Promise((resolve) =>
    setTimeout(resolve, 60_000 * MINUTES, `failed: no answer in ${MINUTES} minutes`),
  );
  const gone = new Promise((resolve) => {
    browser.on("error", ({ message }) => resolve(`failed: ${message}`));
    browser.on("exit", (code) => resolve(`failed: ${program} ended with ${code}`));
  });
  const text = await Promise.race([answer, late, gone]);
  console.log(text);
  process.exitCode = +text.startsWith("failed");
} finally {
  if (browser.pid) {
    browser.removeAllListeners("exit");
    process.kill(-browser.pid);
  }
  server.close();
  post.close();
  post.closeAllConnections();
  await new Promise((later) => setTimeout(later, 500));
  await removed(profile);
  process.exit();
}
