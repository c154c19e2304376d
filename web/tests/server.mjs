// A static file server of this repository's `web` and `robot`, which is all that a page needs.
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";

const ROOT = new URL("../..", import.meta.url).pathname;
const TYPES = {
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript",
  ".mjs": "text/javascript",
  ".wasm": "application/wasm",
  ".css": "text/css",
  ".png": "image/png",
  ".md": "text/plain; charset=utf-8",
  ".ts": "text/plain; charset=utf-8",
};
const ISOLATED = { "cross-origin-opener-policy": "same-origin", "cross-origin-embedder-policy": "require-corp" };

/**
 * Serves until `close`; `extra` maps further prefixes to folders, such as those of npm. Isolated
 * pages have the finer clock; `first` is put before all else in them.
 */
export async function serve(port = 0, { extra = {}, isolated = false, first = "" } = {}) {
  const headers = isolated ? ISOLATED : {};
  const server = createServer(async (request, answer) => {
    const path = normalize(decodeURIComponent(new URL(request.url, "http://x").pathname));
    const [prefix, folder] = Object.entries(extra).find(([prefix]) => path.startsWith(prefix)) ?? ["", ROOT];
    try {
      if (folder === ROOT && !/^\/((web|robot)\/|README\.md$)/.test(path)) throw new Error("not served");
      const body = await readFile(join(folder, path.slice(prefix.length)));
      const type = TYPES[extname(path)] ?? "application/octet-stream";
      const told = type === TYPES[".html"] ? String(body).replace(/^<!doctype html>/, (kind) => kind + first) : body;
      answer.writeHead(200, { ...headers, "content-type": type }).end(told);
    } catch {
      answer.writeHead(404).end(`${path}: not found`);
    }
  });
  await new Promise((listening) => server.listen(port, "127.0.0.1", listening));
  const close = () => {
    server.close();
    server.closeAllConnections();
  };
  return { url: `http://127.0.0.1:${server.address().port}`, close };
}

if (process.argv[1] === new URL(import.meta.url).pathname) {
  console.log(`${(await serve(8080)).url}/web/page/index.html`);
}
