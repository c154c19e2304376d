import type { Level } from "./engine.js";
declare const relaxed: Level<"dq8/robots">;
export default relaxed;
