// A browser's database, storage and locks in memory, for tests in Node.

/** Contents of the database, by key. @type {Map<string, unknown>} */
export const records = new Map();
/** Names of the held locks, of this and other tabs. @type {Set<string>} */
export const locks = new Set();

/** An event handler is set after the call returns. */
function request(result) {
  const made = { result };
  setTimeout(() => {
    made.onsuccess?.();
    made.oncomplete?.();
  });
  return made;
}

const objectStore = () => ({
  transaction: request(undefined),
  getAllKeys: () => request([...records.keys()]),
  getAll: ([low, high]) =>
    request([...records].filter(([key]) => key >= low && key <= high).map(([, value]) => value)),
  get: (key) => request(records.get(key)),
  put: (value, key) => void records.set(key, value),
  delete: (key) => void records.delete(key),
});

/** Storage: its keys are its own properties. */
class Storage {
  getItem(key) {
    return this[key] ?? null;
  }
  setItem(key, value) {
    this[key] = value;
  }
  removeItem(key) {
    delete this[key];
  }
}

const define = (name, value) =>
  Object.defineProperty(globalThis, name, { value, configurable: true });
define('indexedDB', { open: () => request({ transaction: () => ({ objectStore }) }) });
define('IDBKeyRange', { bound: (low, high) => [low, high] });
define('window', {
  ...{ localStorage: new Storage(), sessionStorage: new Storage() },
  addEventListener() {},
});
define('navigator', {
  locks: {
    query: async () => ({ held: Array.from(locks, (name) => ({ name })) }),
    async request(name, _, hold) {
      locks.add(name);
      await hold({ name });
      locks.delete(name);
    },
  },
});
