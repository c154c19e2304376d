// The same as robots.js, for node, Bun and Deno.
import { read } from "./node.js";
import { compile as compileBy, load as loadBy } from "./robots.js";

export * from "./robots.js";
export const compile = (options) => compileBy(options, read),
  load = (options) => loadBy(options, read);
export default load;
