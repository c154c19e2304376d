// Handles that are taken for the numbers that they have: an error says where those are.

const numbered = (key) => typeof key === "string" && /^-?\d+$/.test(key);
/** What arrays of numbers have, and handles do not. */
const ofArrays = (key) =>
  numbered(key) || key === Symbol.iterator || (typeof key === "string" && key in Float32Array.prototype);

/**
 * Lets reads and writes of what only arrays have fail; what the class has itself is found before.
 */
export function loud(Class) {
  const refuse = (key) => {
    const what = numbered(key) ? `[${key}]` : typeof key === "symbol" ? "iterator" : key;
    throw new TypeError(`an array of dq8 has no ${what}: its numbers are in .view`);
  };
  const base = Object.prototype;
  Object.setPrototypeOf(
    Class.prototype,
    new Proxy(base, {
      get: (_, key, self) => (!(key in base) && ofArrays(key) ? refuse(key) : Reflect.get(base, key, self)),
      set: (_, key, value, self) => (numbered(key) ? refuse(key) : Reflect.set(base, key, value, self)),
    }),
  );
}

/** Lets names that others have for what a class does, or that are of another class, fail with what to take. */
export function guesses(Class, names) {
  for (const [guess, use] of Object.entries(names)) {
    const get = () => {
      throw new TypeError(`${Class.name} has no ${guess}: take ${use}`);
    };
    Object.defineProperty(Class.prototype, guess, { get });
  }
}
