// The same as pack.js, for node, Bun and Deno.
import { read } from "./node.js";
import { compile as compileBy, load as loadBy } from "./pack.js";

export * from "./pack.js";
export const compile = (options) => compileBy(options, read),
  load = (options) => loadBy(options, read);
export default load;
