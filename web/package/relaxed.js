// The level that multiplies and adds in one rounding where the machine does: who does not import it does not ship it.
export default { module: "dq8", name: "relaxed", url: () => new URL("./dq8.relaxed.wasm", import.meta.url) };
