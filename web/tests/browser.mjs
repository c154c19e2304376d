// Debian's Chromium, driven over a pipe by its own protocol: nothing is downloaded.
import { spawn } from "node:child_process";
import { mkdtempSync } from "node:fs";
import { rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";

const CHROMIUM = process.env.CHROMIUM ?? "/usr/bin/chromium";

const FLAGS = [
  "--headless=new", "--no-sandbox", "--remote-debugging-pipe", "--disable-dev-shm-usage", "--disable-gpu-sandbox",
  "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--hide-scrollbars",
];
const VIRTUAL = { ArrowRight: 39, ArrowLeft: 37, ArrowUp: 38, ArrowDown: 40, Tab: 9 };
const pause = (milliseconds) => new Promise((later) => setTimeout(later, milliseconds));

/** Removes a profile. Children of a browser end after it and write until then; `rmSync` retries the folder alone. */
export const removed = (profile) => rm(profile, { recursive: true, force: true, maxRetries: 20, retryDelay: 50 });

/** What a message of a page says to its console, if it is an error or a warning. */
function said({ method, params }) {
  const { exceptionDetails, args, entry } = params;
  if (method === "Runtime.exceptionThrown") return exceptionDetails.exception?.description ?? exceptionDetails.text;
  if (method === "Runtime.consoleAPICalled" && ["error", "warning", "assert"].includes(params.type))
    return args.map((a) => a.value ?? a.description).join(" ");
  if (method === "Log.entryAdded" && entry.level === "error") return `${entry.text} ${entry.url ?? ""}`;
  return undefined;
}

export async function open({ flags = [] } = {}) {
  const profile = mkdtempSync(join(tmpdir(), "dq8-chromium-"));
  const process_ = spawn(CHROMIUM, [...FLAGS, `--user-data-dir=${profile}`, ...flags, "about:blank"], {
    stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"],
  });
  const [, , , to, from] = process_.stdio, waiting = new Map(), listeners = [];
  let last = 0, rest = "";
  from.setEncoding("utf8").on("data", (chunk) => {
    const parts = (rest + chunk).split("\0");
    rest = parts.pop();
    for (const message of parts.map((part) => JSON.parse(part))) {
      if (!message.id) {
        for (const listen of listeners) listen(message);
        continue;
      }
      const { resolve, reject } = waiting.get(message.id);
      waiting.delete(message.id);
      message.error ? reject(new Error(message.error.message)) : resolve(message.result);
    }
  });
  // Who asks a browser that is gone gets an answer, too.
  let ended;
  const gone = (why) => {
    ended = new Error(`Chromium: ${why}`);
    for (const { reject } of waiting.values()) reject(ended);
    waiting.clear();
  };
  process_.on("exit", (code) => gone(`ended with ${code}`)).on("error", (error) => gone(error.message));
  const send = (method, params = {}, sessionId) => new Promise((resolve, reject) => {
    if (ended) return reject(ended);
    waiting.set(++last, { resolve, reject });
    to.write(`${JSON.stringify({ id: last, method, params, sessionId })}\0`);
  });
  return {
    /** A page, what its console said, and what can be done with it; a mobile one takes fingers. */
    async page(url, { width = 1000, height = 800, mobile = false, before } = {}) {
      const { targetId } = await send("Target.createTarget", { url: "about:blank" });
      const { sessionId } = await send("Target.attachToTarget", { targetId, flatten: true });
      const call = (method, params) => send(method, params, sessionId), messages = [];
      listeners.push((message) => {
        const text = message.sessionId === sessionId ? said(message) : undefined;
        if (text !== undefined) messages.push(text);
      });
      await Promise.all([
        call("Runtime.enable"), call("Page.enable"), call("Log.enable"),
        call("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: 1, mobile }),
        call("Emulation.setTouchEmulationEnabled", { enabled: mobile }),
      ]);
      if (before) await call("Page.addScriptToEvaluateOnNewDocument", { source: before });
      await call("Page.navigate", { url });
      /** The value of an expression, awaited. */
      const evaluate = async (expression) => {
        const asked = { expression, awaitPromise: true, returnByValue: true },
          { result, exceptionDetails } = await call("Runtime.evaluate", asked);
        if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
        return result.value;
      };
      return {
        call, evaluate, messages,
        async until(expression, seconds = 60) {
          for (const end = Date.now() + 1000 * seconds; Date.now() < end;) {
            const value = await evaluate(expression).catch(() => undefined);
            if (value) return value;
            await pause(100);
          }
          throw new Error(`after ${seconds} s it does not hold: ${expression}\n${messages.join("\n")}`);
        },
        async key(key, { code = key, text } = {}) {
          for (const type of ["keyDown", "keyUp"]) {
            await call("Input.dispatchKeyEvent", { type, key, code, text, windowsVirtualKeyCode: VIRTUAL[key] });
          }
        },
        /** A finger goes from a place by so many pixels. */
        async swipe(x, y, right, down, steps = 10) {
          const touch = (type, ...touchPoints) => call("Input.dispatchTouchEvent", { type, touchPoints });
          await touch("touchStart", { x, y });
          for (let i = 1; i <= steps; i++) {
            await touch("touchMove", { x: x + (right * i) / steps, y: y + (down * i) / steps });
            await pause(16);
          }
          // Fingers that rest before they leave do not throw.
          await pause(100);
          await touch("touchEnd");
          await pause(300);
        },
        close: () => send("Target.closeTarget", { targetId }),
        /** Of all of it, so much smaller. */
        async screenshot(scale = 1) {
          const { cssContentSize: { width, height } } = await call("Page.getLayoutMetrics"),
            clip = { x: 0, y: 0, width, height, scale };
          const { data } = await call("Page.captureScreenshot", { format: "png", captureBeyondViewport: true, clip });
          return Buffer.from(data, "base64");
        },
      };
    },
    async close() {
      const ended = new Promise((ended) => process_.once("exit", ended));
      await Promise.race([send("Browser.close").catch(() => {}), pause(3000)]);
      if (process_.exitCode === null) process_.kill();
      await ended;
      await removed(profile);
    },
  };
}
