import { answer } from "./app.js";

answer().then(
  (text) => {
    globalThis.answer = text;
    console.log(text);
  },
  (error) => {
    globalThis.answer = String(error);
    console.log(error);
  },
);
