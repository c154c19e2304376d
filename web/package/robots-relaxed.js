// The same level of dq8/robots.
export default { module: "dq8/robots", name: "relaxed", url: () => new URL("./robots.relaxed.wasm", import.meta.url) };
