// The relaxed level, and what stands in for it.
import { LevelError } from "dq8";
import relaxed from "dq8/relaxed";
import robotsRelaxed from "dq8/robots-relaxed";
import { answer } from "./app.js";

const strictly = await answer({ level: relaxed }, { level: robotsRelaxed }).then(
  () => "relaxed",
  (error) => {
    if (!(error instanceof LevelError)) throw error;
    return error.name;
  },
);
console.log(
  `${strictly}: ${await answer({ level: relaxed, fallback: true }, { level: robotsRelaxed, fallback: true })}`,
);
