// The same as dq8.js, for node, Bun and Deno.
import { read } from "./node.js";
import { compile as compileBy, load as loadBy } from "./dq8.js";

export * from "./dq8.js";
export const compile = (options) => compileBy(options, read),
  load = (options) => loadBy(options, read);
export default load;
