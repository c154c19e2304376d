// Files are read in workers, one for each: what a file has made is given up with its worker.

/** The worker that reads a file, and the promise of what it makes of it. */
export function read(kind, file, progress) {
  const worker = new Worker(new URL("reader.js", import.meta.url), { type: "module" });
  let answers = false;
  const made = new Promise((resolve, reject) => {
    const fail = (text) => {
      worker.terminate();
      reject(new Error(text));
    };
    worker.onmessage = ({ data: { part, made, error } }) => {
      answers = true;
      if (part !== undefined) progress(part);
      else if (made) resolve({ ...made, worker });
      else fail(error);
    };
    worker.onerror = ({ message = "no reason is known" }) => {
      const why = answers ? "its reader failed" : "its reader, a worker that is a module, does not start";
      fail(`${why}${answers ? "" : ", as in browsers before 2023"}: ${message}`);
    };
    worker.postMessage({ kind, file });
  });
  return { worker, made };
}
