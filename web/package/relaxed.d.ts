import type { Level } from "./engine.js";
declare const relaxed: Level<"dq8">;
export default relaxed;
