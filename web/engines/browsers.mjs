// Firefox and WebKitGTK, driven by what Debian's packages bring: Marionette, over a socket, and WebDriver, over HTTP.
// Both know the same commands.
import { spawn } from "node:child_process";
import { mkdtempSync, writeFileSync } from "node:fs";
import { connect, createServer } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { removed } from "../tests/browser.mjs";

const MINIBROWSER = "/usr/lib/x86_64-linux-gnu/webkit2gtk-4.1/MiniBrowser";
/** How long a browser may take to start, in milliseconds. */
const START = 60_000;
/** Firefox's bars are within. */
const WINDOW = { x: 0, y: 0, width: 1280, height: 985 };
/** The name of an element's number, which the protocol prescribes. */
const ELEMENT = "element-6066-11e4-a52e-4f735466cecf";
const KEYS = { ArrowLeft: "\uE012" };
const pause = (milliseconds) => new Promise((later) => setTimeout(later, milliseconds));

async function freePort() {
  const server = createServer();
  await new Promise((listening) => server.listen(0, "127.0.0.1", listening));
  const { port } = server.address();
  await new Promise((closed) => server.close(closed));
  return port;
}

/** What `attempt` answers as soon as it does not fail. */
async function patiently(attempt) {
  for (const end = Date.now() + START; ; await pause(200)) {
    try {
      return await attempt();
    } catch (error) {
      if (Date.now() > end) throw error;
    }
  }
}

/** Commands by Marionette: a message is its length, a colon, and [0, number, command, parameters]. */
async function marionette(port) {
  const socket = await patiently(() => new Promise((resolve, reject) => {
    const socket = connect(port, "127.0.0.1", () => resolve(socket)).once("error", reject);
  }));
  const waiting = new Map();
  let rest = Buffer.alloc(0), last = 0;
  socket.on("data", (chunk) => {
    rest = Buffer.concat([rest, chunk]);
    for (;;) {
      const colon = rest.indexOf(":"), end = colon + 1 + Number(rest.subarray(0, Math.max(0, colon)));
      if (colon < 0 || rest.length < end) return;
      const message = JSON.parse(rest.subarray(colon + 1, end));
      rest = rest.subarray(end);
      // The first message is no answer: it says which version speaks.
      if (!Array.isArray(message)) continue;
      const [, number, error, answer] = message, { resolve, reject } = waiting.get(number);
      waiting.delete(number);
      error ? reject(new Error(error.message)) : resolve(answer);
    }
  });
  socket.on("close", () => {
    for (const { reject } of waiting.values()) reject(new Error("Firefox has ended"));
  });
  const call = (command, parameters = {}) => new Promise((resolve, reject) => {
    waiting.set(++last, { resolve, reject });
    const text = JSON.stringify([0, last, `WebDriver:${command}`, parameters]);
    socket.write(`${Buffer.byteLength(text)}:${text}`);
  });
  await call("NewSession");
  const value = async (...command) => (await call(...command)).value;
  return {
    resize: () => call("SetWindowRect", WINDOW),
    go: (url) => call("Navigate", { url }),
    run: (script) => value("ExecuteAsyncScript", { script, args: [] }),
    picture: () => value("TakeScreenshot", { full: false }),
    find: async (css) => (await value("FindElement", { using: "css selector", value: css }))[ELEMENT],
    type: (id, text) => call("ElementSendKeys", { id, text }),
  };
}

/** Commands by WebDriver. */
async function webdriver(port) {
  const send = async (path, parameters) => {
    const answer = await fetch(`http://127.0.0.1:${port}/session${path}`, parameters && {
      method: "POST",
      body: JSON.stringify(parameters),
    });
    const { value } = await answer.json();
    if (!answer.ok) throw new Error(value.message || value.error);
    return value;
  };
  const browser = { binary: MINIBROWSER, args: ["--automation"] },
    wanted = { alwaysMatch: { "webkitgtk:browserOptions": browser } };
  const { sessionId } = await patiently(() => send("", { capabilities: wanted }));
  const call = (path, parameters) => send(`/${sessionId}${path}`, parameters);
  return {
    resize: () => call("/window/rect", WINDOW),
    go: (url) => call("/url", { url }),
    run: (script) => call("/execute/async", { script, args: [] }),
    picture: () => call("/screenshot"),
    find: async (css) => (await call("/element", { using: "css selector", value: css }))[ELEMENT],
    type: (id, text) => call(`/element/${id}/value`, { text }),
  };
}

const BROWSERS = {
  firefox: {
    connect: marionette,
    program: (port, profile) => {
      const lines = { "marionette.port": port, "webgl.force-enabled": true };
      const text = Object.entries(lines).map(([name, value]) => `user_pref("${name}", ${JSON.stringify(value)});\n`);
      writeFileSync(join(profile, "user.js"), text.join(""));
      return ["firefox-esr", "--no-remote", "--marionette", "--profile", profile];
    },
  },
  webkit: { connect: webdriver, program: (port) => ["WebKitWebDriver", `--port=${port}`] },
};

/** A browser of a name, on a screen that nobody sees: WebGL is not there without a screen. */
export async function drive(name) {
  const { program, connect } = BROWSERS[name], port = await freePort();
  const profile = mkdtempSync(join(tmpdir(), "dq8-browser-"));
  const env = {
    ...process.env,
    HOME: profile,
    LIBGL_ALWAYS_SOFTWARE: "1",
    // WebKit's sandbox wants rights that containers lack.
    WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS: "1",
  };
  const screen = ["-a", "-s", "-screen 0 1280x1000x24"], printed = [];
  // A group of its own, whose processes end together.
  const started = spawn("xvfb-run", [...screen, ...program(port, profile)], { env, detached: true });
  for (const pipe of [started.stdout, started.stderr]) {
    pipe.setEncoding("utf8").on("data", (text) => printed.push(text));
  }
  async function close() {
    const gone = new Promise((gone) => started.once("exit", gone));
    if (started.exitCode === null) {
      process.kill(-started.pid);
      await gone;
    }
    await removed(profile);
  }
  try {
    const { resize, go, run, picture, find, type } = await connect(port);
    await resize();
    /** The value of an expression, awaited. */
    async function evaluate(expression) {
      const [error, value] = await run(`const done = arguments[arguments.length - 1];
        (async () => (${expression}))().then((value) => done([null, value]), (error) => done([String(error), null]));`);
      if (error !== null) throw new Error(error);
      return value;
    }
    return {
      go, close, evaluate,
      async until(expression, seconds = 60) {
        for (const end = Date.now() + 1000 * seconds; Date.now() < end; await pause(100)) {
          const value = await evaluate(expression).catch(() => undefined);
          if (value) return value;
        }
        throw new Error(`after ${seconds} s it does not hold: ${expression}`);
      },
      picture: async () => Buffer.from(await picture(), "base64"),
      /** Types text or a key where a selector leads; a path, for an input of files. */
      type: async (css, text) => type(await find(css), KEYS[text] ?? text),
      /** What the engine itself has said about the page at an address. Firefox alone prints that. */
      printed: (url) => printed.join("").split("\n")
        .filter((line) => /^JavaScript (error|warning): /.test(line) && line.includes(url)),
    };
  } catch (error) {
    await close();
    throw new Error(`${name} does not start: ${error.message}\n${printed.join("")}`, { cause: error });
  }
}
