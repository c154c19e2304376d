// A project that has installed the package from the tarball that `npm pack` makes.
import { execFileSync } from "node:child_process";
import { cpSync, mkdtempSync, readdirSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

const HERE = fileURLToPath(new URL(".", import.meta.url));
export const TOOLS = join(HERE, "node_modules");

/** Runs a program, and throws what it said if it fails. */
export function run(program, args, { cwd, env = {} } = {}) {
  try {
    return execFileSync(program, args, {
      cwd,
      env: { ...process.env, ...env },
      encoding: "utf8",
      stdio: ["ignore", "pipe", "pipe"],
    });
  } catch (error) {
    const said = `${error.stdout ?? ""}${error.stderr ?? error.message}`.split("\n").map((line) => line.slice(0, 300));
    throw new Error(`${program} ${args.join(" ")}\n${said.slice(-60).join("\n")}`);
  }
}

/** The folder of a new project, the names in the tarball, and what removes the folder. */
export function project() {
  const folder = mkdtempSync(join(tmpdir(), "dq8-packed-"));
  const made = run("npm", ["pack", "--json", "--pack-destination", folder], { cwd: join(HERE, "../package") });
  const [{ filename, files }] = JSON.parse(made.slice(made.indexOf("[")));
  writeFileSync(join(folder, "package.json"), JSON.stringify({ private: true, type: "module" }));
  run("npm", ["install", "--offline", "--no-audit", "--no-fund", join(folder, filename)], { cwd: folder });
  for (const name of readdirSync(HERE)) if (/\.js$/.test(name)) cpSync(join(HERE, name), join(folder, name));
  for (const tool of ["three"]) symlinkSync(join(TOOLS, tool), join(folder, "node_modules", tool));
  return {
    folder,
    files: files.map(({ path }) => path),
    remove: () => rmSync(folder, { recursive: true, force: true }),
  };
}
