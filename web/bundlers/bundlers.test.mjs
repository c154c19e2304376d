// From one tarball: what is in it, bundles that run in Chromium, engines beside browsers, and compilers of TypeScript.
import assert from "node:assert/strict";
import { cpSync, existsSync, mkdirSync, readdirSync, writeFileSync } from "node:fs";
import { after, before, describe, test } from "node:test";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { open } from "../tests/browser.mjs";
import { serve } from "../tests/server.mjs";
import { TOOLS, project, run } from "./packed.mjs";

const RIGHT = "3 6 9 | frame leaf | 1 2 3 | 1.5";
const QUICK = Boolean(process.env.QUICK),
  skip = QUICK && "without --quick";
const tool = (name) => import(pathToFileURL(join(TOOLS, name)));
/** The files that esbuild and Rollup leave, as the README has it. */
const copy = (to) => {
  for (const name of ["dq8", "robots", "pack"])
    cpSync(join(folder, `node_modules/dq8/${name}.simd128.wasm`), join(to, `${name}.simd128.wasm`));
};
const HTML = (script) =>
  `<!doctype html><meta charset="utf-8"><link rel="icon" href="data:,"><script type="module" src="${script}"></script>`;

let folder, files, remove, server, browser;
before(async () => {
  ({ folder, files, remove } = project());
  [server, browser] = await Promise.all([serve(0, { extra: { "/project": folder } }), open()]);
});
after(async () => {
  await browser?.close();
  server?.close();
  remove?.();
});

const levels = () => ["simd128", "relaxed"].filter((level) => files.includes(`dq8.${level}.wasm`));

/** A folder of its own for a bundle, and the answer of its page in Chromium. */
async function answer(name, bundle, html = HTML("./main.js")) {
  const out = join(folder, name);
  mkdirSync(out, { recursive: true });
  if (html) writeFileSync(join(out, "index.html"), html);
  await bundle(out);
  const page = await browser.page(`${server.url}/project/${name}/index.html`);
  const answer = await page.until("globalThis.answer", 30);
  return { answer, messages: page.messages, page };
}
async function answers(...given) {
  const { answer: got, messages } = await answer(...given);
  assert.equal(got, RIGHT);
  assert.deepEqual(messages, []);
}

test("the tarball has all modules, their types, and the texts of both licences", () => {
  for (const name of ["dq8", "robots", "pack"])
    for (const end of ["js", "node.js", "d.ts", "simd128.wasm"])
      assert.ok(files.includes(`${name}.${end}`), `${name}.${end}`);
  for (const name of ["LICENSE-MIT", "LICENSE-APACHE", "README.md"]) assert.ok(files.includes(name), name);
  const manifest = JSON.parse(run("node", ["-p", "JSON.stringify(require('dq8/package.json'))"], { cwd: folder }));
  const paths = Object.values(manifest.exports).flatMap((to) => (typeof to === "string" ? to : Object.values(to)));
  for (const path of [...paths, manifest.main, manifest.types])
    if (!path.includes("*")) assert.ok(files.includes(path.slice(2)), path);
  assert.ok(!files.some((file) => /test|\.sh$|\.mjs$/.test(file)));
});

test("without a compiler and without a module nothing is packed, and words say what is missing", () => {
  const copyOf = join(folder, "clone/web/package");
  mkdirSync(copyOf, { recursive: true });
  cpSync(new URL("../build.sh", import.meta.url), join(folder, "clone/web/build.sh"));
  cpSync(new URL("../package/package.json", import.meta.url), join(copyOf, "package.json"));
  // A machine without any compiler is one whose compilers know no folder of a library.
  const tools = join(folder, "none");
  mkdirSync(tools, { recursive: true });
  for (const name of ["rustc", "id"])
    writeFileSync(join(tools, name), name === "id" ? "#!/bin/sh\necho 1000\n" : "#!/bin/sh\necho /none\n", {
      mode: 0o755,
    });
  const env = { PATH: `${tools}:${process.env.PATH}`, RUSTC: join(tools, "rustc") };
  assert.throws(
    () => run("npm", ["pack"], { cwd: copyOf, env }),
    /No Rust compiler here makes WebAssembly[^]*rustup target add wasm32-unknown-unknown/,
  );
  assert.ok(!readdirSync(copyOf).some((file) => file.endsWith(".tgz")));
});

describe("bundles in Chromium", () => {
  test("esbuild, the files copied beside the bundle", async () => {
    const { build } = await tool("esbuild/lib/main.js");
    await answers("esbuild", async (outdir) => {
      const { warnings } = await build({
        absWorkingDir: folder,
        entryPoints: ["main.js"],
        bundle: true,
        minify: true,
        format: "esm",
        outdir,
        logLevel: "silent",
      });
      assert.deepEqual(warnings, []);
      copy(outdir);
    });
  });

  test("esbuild, the files in the bundle", async () => {
    const { build } = await tool("esbuild/lib/main.js");
    await answers(
      "binary",
      (outdir) =>
        build({
          absWorkingDir: folder,
          entryPoints: ["binary.js"],
          bundle: true,
          format: "iife",
          target: "es2022",
          outdir,
          loader: { ".wasm": "binary" },
          logLevel: "error",
          logOverride: { "empty-import-meta": "silent" },
        }),
      HTML("./binary.js"),
    );
  });

  test("a bundle without its file, one that is no module, and a strict policy say what is wrong", async () => {
    const { build } = await tool("esbuild/lib/main.js");
    const bundle = (format) => (outdir) =>
      build({ absWorkingDir: folder, entryPoints: ["main.js"], bundle: true, format, outdir, logLevel: "silent" });
    assert.match(
      (await answer("lost", bundle("esm"))).answer,
      /dq8\.simd128\.wasm: 404 Not Found\. esbuild and Rollup copy no such files/,
    );
    assert.match(
      (await answer("classic", bundle("iife"))).answer,
      /no import\.meta\.url .* make it an ES module, or pass/,
    );
    const policy = (sources) =>
      HTML("./main.js").replace(
        "<link",
        `<meta http-equiv="Content-Security-Policy" content="script-src ${sources}"><link`,
      );
    const both = async (outdir) => {
      await bundle("esm")(outdir);
      copy(outdir);
    };
    assert.match(
      (await answer("strict", both, policy("'self'"))).answer,
      /content security policy forbids WebAssembly: script-src needs 'wasm-unsafe-eval'/,
    );
    assert.equal((await answer("open", both, policy("'self' 'wasm-unsafe-eval'"))).answer, RIGHT);
  });

  test("Rollup, the files copied beside the bundle", async () => {
    const [{ rollup }, { nodeResolve }] = await Promise.all([
      tool("rollup/dist/es/rollup.js"),
      tool("@rollup/plugin-node-resolve/dist/es/index.js"),
    ]);
    await answers("rollup", async (dir) => {
      const onLog = (level, { message }) => assert.fail(message);
      const bundle = await rollup({ input: join(folder, "main.js"), plugins: [nodeResolve({ browser: true })], onLog });
      await bundle.write({ dir, format: "es" });
      copy(dir);
    });
  });

  test("Vite", { skip }, async () => {
    const { build } = await tool("vite/dist/node/index.js"),
      root = join(folder, "vite-root");
    mkdirSync(root);
    for (const name of ["main.js", "app.js"]) cpSync(join(folder, name), join(root, name));
    writeFileSync(join(root, "index.html"), HTML("./main.js"));
    await answers(
      "vite",
      (outDir) =>
        build({ root, base: "./", configFile: false, logLevel: "error", build: { outDir, emptyOutDir: true } }),
      null,
    );
  });

  test("webpack", { skip }, async () => {
    const { default: webpack } = await tool("webpack/lib/index.js");
    await answers(
      "webpack",
      (path) =>
        new Promise((resolve, reject) => {
          webpack(
            {
              context: folder,
              entry: "./main.js",
              mode: "production",
              output: { path, filename: "main.js" },
              performance: false, // Its hints are about the sizes of files.
            },
            (error, stats) => {
              if (error || stats.hasErrors() || stats.hasWarnings()) reject(error ?? new Error(stats.toString()));
              else resolve();
            },
          );
        }),
    );
  });

  test("Parcel", { skip }, async () => {
    writeFileSync(join(folder, "parcel.html"), HTML("./main.js"));
    await answers(
      "parcel",
      (out) => {
        run(
          "node",
          [
            join(TOOLS, "parcel/lib/bin.js"),
            "build",
            "parcel.html",
            "--dist-dir",
            out,
            "--public-url",
            "./",
            "--no-cache",
            "--no-source-maps",
          ],
          { cwd: folder },
        );
        cpSync(join(out, "parcel.html"), join(out, "index.html"));
      },
      null,
    );
  });
});

describe("engines beside browsers", () => {
  const engines = {
    "this node": [process.execPath],
    "node 18": [join(TOOLS, "node-18/bin/node")],
    "node 20": [join(TOOLS, "node-20/bin/node")],
    "node 22": [join(TOOLS, "node-22/bin/node")],
    "node 24": [join(TOOLS, "node-24/bin/node")],
    Bun: [join(TOOLS, "@oven/bun-linux-x64/bin/bun")],
    Deno: [join(TOOLS, "@deno/linux-x64-glibc/deno"), "run", "--allow-read"],
  };
  for (const [name, [program, ...args]] of Object.entries(engines)) {
    test(name, { skip: name !== "this node" && skip }, () => {
      assert.equal(run(program, [...args, "main.js"], { cwd: folder }).trim(), RIGHT);
      // Where the engine lacks the level, the other stands in for it.
      if (levels().includes("relaxed"))
        assert.match(
          run(program, [...args, "levels.js"], { cwd: folder }).trim(),
          new RegExp(`^(relaxed|LevelError): ${RIGHT.replaceAll("|", "\\|")}$`),
        );
    });
  }

  test("a bundle for node reads the files beside it", async () => {
    const { build } = await tool("esbuild/lib/main.js"),
      outdir = join(folder, "bundled");
    await build({
      absWorkingDir: folder,
      entryPoints: ["main.js"],
      bundle: true,
      platform: "node",
      format: "esm",
      outdir,
      outExtension: { ".js": ".mjs" },
      logLevel: "error",
    });
    assert.match(
      run("node", ["bundled/main.mjs"], { cwd: folder }),
      /dq8\.simd128\.wasm cannot be read: ENOENT.*copy it beside the bundle/,
    );
    copy(outdir);
    assert.equal(run("node", ["bundled/main.mjs"], { cwd: folder }).trim(), RIGHT);
  });
});

describe("TypeScript, without skipLibCheck", () => {
  for (const version of ["5.2", "5.4", "5.6", "5.9", "6.0", "7.0"]) {
    test(version, { skip: !["5.2", "5.9"].includes(version) && skip }, () => {
      cpSync(new URL("../tests/types.mts", import.meta.url), join(folder, "types.mts"));
      const compile = (name, options) => {
        writeFileSync(
          join(folder, `tsconfig.${name}.json`),
          JSON.stringify({
            compilerOptions: {
              strict: true,
              noEmit: true,
              skipLibCheck: false,
              target: "ES2022",
              types: [],
              ...options,
            },
            files: ["types.mts"],
          }),
        );
        run("node", [join(TOOLS, `typescript-${version}/bin/tsc`), "-p", `tsconfig.${name}.json`], { cwd: folder });
      };
      compile("nodenext", { module: "NodeNext", lib: ["ES2022"] });
      if (Number(version) < 6) compile("node10", { module: "ES2022", moduleResolution: "node10", lib: ["ES2022"] });
      // The types of pages are many, and checked as well.
      if (!QUICK) compile("bundler", { module: "ES2022", moduleResolution: "bundler", lib: ["ES2022", "DOM"] });
    });
  }
});
