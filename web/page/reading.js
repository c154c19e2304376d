// Files are read in workers, one for each: what a file has made is given up with its worker.

/** Ends a worker. What it had to say may be under way, and is not heard. */
export function end(worker) {
  worker.onmessage = worker.onerror = null;
  worker.terminate();
}

/** The worker that reads a file, and the promise of what it makes of it. */
export function read(kind, file, progress) {
  const worker = new Worker(new URL("reader.js", import.meta.url), { type: "module" });
  let answers = false;
  const made = new Promise((resolve, reject) => {
    const fail = (text) => {
      end(worker);
      reject(new Error(text));
    };
    worker.onmessage = ({ data: { part, made, error } }) => {
      answers = true;
      if (part !== undefined) progress(part);
      else if (made) resolve({ ...made, worker });
      else fail(error);
    };
    worker.onerror = ({ message = "no reason is known" }) => {
      const old = "its reader, a worker that is a module, does not start, as in browsers before 2023";
      fail(`${answers ? "its reader failed" : old}: ${message}`);
    };
    worker.postMessage({ kind, file });
  });
  return { worker, made };
}
