// Runs one program of the test suite: node wasi.mjs PROGRAM ARGUMENT…
import { readFile } from 'node:fs/promises';
import { argv, env } from 'node:process';
import { WASI } from 'node:wasi';

const [program, ...rest] = argv.slice(2);
// Tests read their data by the absolute paths of the build.
const wasi = new WASI({ version: 'preview1', args: [program, ...rest], env, preopens: { '/': '/' } });
// The standard library names functions for threads that Debian's C library does not have: whatever is called of them fails.
const threads = new Proxy({}, { get: () => () => 1 });
const { instance } = await WebAssembly.instantiate(await readFile(program), { ...wasi.getImportObject(), env: threads });
process.exitCode = wasi.start(instance);
