// Runs one program of the test suite: node wasi.mjs PROGRAM ARGUMENT…
import { readFile } from 'node:fs/promises';
import { argv, cwd, env } from 'node:process';
import { WASI } from 'node:wasi';

const [program, ...rest] = argv.slice(2);
// Tests read their data by the absolute paths of the build.
const wasi = new WASI({ version: 'preview1', args: [program, ...rest], env, preopens: { '/': '/', '.': cwd() } });
// The standard library names these two, which Debian's C library does not have; without threads nothing calls them.
const threads = { pthread_join: () => 1, pthread_detach: () => 1 };
const { instance } = await WebAssembly.instantiate(await readFile(program), { ...wasi.getImportObject(), env: threads });
process.exitCode = wasi.start(instance);
