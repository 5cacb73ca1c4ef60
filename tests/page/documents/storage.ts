// A browser's database, storage and locks in memory, for tests in Node.

/** Contents of the database, by key. */
export const records: Map<string, unknown> = new Map();
/** Names of the held locks, of this and other tabs. */
export const locks: Set<string> = new Set();

/** A request with the handler that the page sets. */
interface Request {
  result: unknown;
  onsuccess?: () => void;
}

/** An event handler is set after the call returns. */
function request(result: unknown) {
  const made: Request = { result };
  setTimeout(() => made.onsuccess?.());
  return made;
}

/** What is done in it is done as a whole or, where a request fails, not at all. */
class Transaction {
  error: unknown = null;
  oncomplete?: () => void;
  onerror?: () => void;
  onabort?: () => void;
  readonly changes: (() => void)[] = [];

  constructor() {
    setTimeout(() => this.#end());
  }

  #end() {
    const before = [...records];
    try {
      for (const change of this.changes) change();
      this.oncomplete?.();
    } catch (error) {
      records.clear();
      for (const [key, value] of before) Map.prototype.set.call(records, key, value);
      // The error of a request comes before the reason why the transaction is aborted.
      this.onerror?.();
      this.error = error;
      this.onabort?.();
    }
  }
}

function objectStore() {
  const transaction = new Transaction();
  return {
    transaction,
    getAllKeys: () => request([...records.keys()]),
    getAll: ([low, high]: [string, string]) =>
      request([...records].filter(([key]) => key >= low && key <= high).map(([, value]) => value)),
    get: (key: string) => request(records.get(key)),
    put: (value: unknown, key: string) =>
      void transaction.changes.push(() => void records.set(key, value)),
    delete: (key: string) => void transaction.changes.push(() => void records.delete(key)),
  };
}

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
