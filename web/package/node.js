// Files of the package in node, Bun and Deno, whose fetch reads none.
import { readFile } from "node:fs/promises";
import { readBy } from "./engine.js";

export const read = readBy(readFile);
