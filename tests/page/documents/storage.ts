// A browser's database, storage and locks in memory, for tests in Node.

/** Contents of the database, by key. */
export const records: Map<string, unknown> = new Map();
/** Names of the held locks, of this and other tabs. */
export const locks: Set<string> = new Set();

/** A request, or the transaction of a store, with the handlers that the page sets. */
interface Request {
  result: unknown;
  onsuccess?: () => void;
  oncomplete?: () => void;
}

/** An event handler is set after the call returns. */
function request(result: unknown) {
  const made: Request = { result };
  setTimeout(() => {
    made.onsuccess?.();
    made.oncomplete?.();
  });
  return made;
}

const objectStore = () => ({
  transaction: request(undefined),
  getAllKeys: () => request([...records.keys()]),
  getAll: ([low, high]: [string, string]) =>
    request([...records].filter(([key]) => key >= low && key <= high).map(([, value]) => value)),
  get: (key: string) => request(records.get(key)),
  put: (value: unknown, key: string) => void records.set(key, value),
  delete: (key: string) => void records.delete(key),
});

/** Storage: its keys are its own properties. */
class Storage {
  [key: string]: unknown;
  getItem(key: string) {
    return this[key] ?? null;
  }
  setItem(key: string, value: string) {
    this[key] = value;
  }
  removeItem(key: string) {
    delete this[key];
  }
}

const define = (name: string, value: unknown) =>
  Object.defineProperty(globalThis, name, { value, configurable: true });
define('indexedDB', { open: () => request({ transaction: () => ({ objectStore }) }) });
define('IDBKeyRange', { bound: (low: string, high: string) => [low, high] });
define('window', {
  ...{ localStorage: new Storage(), sessionStorage: new Storage() },
  addEventListener() {},
  setTimeout,
});
define('navigator', {
  locks: {
    query: async () => ({ held: Array.from(locks, (name) => ({ name })) }),
    async request(name: string, how: LockOptions, hold: (lock: object | null) => unknown) {
      if (how.ifAvailable && locks.has(name)) return hold(null);
      locks.add(name);
      await hold({ name });
      locks.delete(name);
    },
  },
});
