// The same in headless Chromium: node bench/chromium.mjs [LEVEL…]
import { serve } from "../tests/server.mjs";
import { open } from "../tests/browser.mjs";

const levels = process.argv.length > 2 ? process.argv.slice(2) : ["simd128"];
const server = await serve(0, {
    isolated: true,
    extra: { "/node_modules": new URL("node_modules", import.meta.url).pathname },
  }),
  browser = await open();
try {
  const page = await browser.page(`${server.url}/web/bench/index.html`);
  await page.until("window.ready");
  console.log(await page.evaluate("navigator.userAgent"));
  console.log(await page.evaluate(`start(${JSON.stringify(levels)})`));
  if (page.messages.length) throw new Error(page.messages.join("\n"));
} finally {
  await browser.close();
  server.close();
}
