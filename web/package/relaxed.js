// The level that multiplies and adds in one rounding where the machine does.
// Bundles have the file only if they import this.
export default { module: "dq8", name: "relaxed", url: () => new URL("./dq8.relaxed.wasm", import.meta.url) };
