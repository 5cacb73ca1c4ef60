// What the machine can do at best in the browser: move bytes, and compute in registers.

/** Accumulators of a loop, which do not wait for each other. */
const ACCUMULATORS = 8;

/** Numbers by precision: lanes of a register, their type, one half, and codes of their instructions. */
const SINGLE = {
  ...{ lanes: 4, type: 0x7d, half: [0x43, 0, 0, 0, 0x3f] },
  ...{ splat: 0x13, extract: 0x1f, add: 0xe4, multiply: 0xe6 },
};
const DOUBLE = {
  ...{ lanes: 2, type: 0x7c, half: [0x44, 0, 0, 0, 0, 0, 0, 0xe0, 0x3f] },
  ...{ splat: 0x14, extract: 0x21, add: 0xf0, multiply: 0xf2, divide: 0xf3 },
};

const [get, set, tee, vector] = [0x20, 0x21, 0x22, 0xfd];

/** A module with one function `run`: in all accumulators it takes a step `n` times. */
function arithmetic({ type, half, splat, extract, add }, step) {
  // Local 0 is n, local 1 has one half in all lanes.
  const own = Array.from({ length: ACCUMULATORS }, (_, k) => 2 + k);
  const loop = [0x03, 0x40, ...own.flatMap(step), get, 0, 0x41, 1, 0x6b, tee, 0, 0x0d, 0, 0x0b];
  // All are read in the end, or the engine would leave them out.
  const [first, ...others] = own;
  const plus = (a) => [get, a, vector, add, 0x01];
  const total = [get, first, ...others.flatMap(plus), vector, extract, 0];
  const start = [...half, vector, splat, set, 1];
  const body = [1, 1 + ACCUMULATORS, 0x7b, ...start, ...loop, ...total, 0x0b];
  const sized = (bytes) => {
    const [low, high] = [bytes.length & 127, bytes.length >> 7];
    return [...(high ? [low | 128, high] : [low]), ...bytes];
  };
  const sections = [
    [1, [1, 0x60, 1, 0x7f, 1, type]],
    [3, [1, 0]],
    [7, [1, ...sized([...'run'].map((letter) => letter.charCodeAt())), 0, 0]],
    [10, [1, ...sized(body)]],
  ];
  const magic = [0, 0x61, 0x73, 0x6d, 1, 0, 0, 0];
  return Uint8Array.from([...magic, ...sections.flatMap(([id, bytes]) => [id, ...sized(bytes)])]);
}

/** a = a / 2 + 1 / 2 */
const multiplied =
  ({ multiply, add }) =>
  (a) => [get, a, get, 1, vector, multiply, 0x01, get, 1, vector, add, 0x01, set, a];
/** a = 1 / 2 / (a + 1 / 2) */
const divided =
  ({ divide, add }) =>
  (a) => [get, 1, get, a, get, 1, vector, add, 0x01, vector, divide, 0x01, set, a];

/** The shortest of the calls within some time, in milliseconds: when nothing interrupts it. */
function shortest(call, within) {
  let least = Infinity;
  for (let [k, start] = [0, performance.now()]; k < 5 || performance.now() - start < within; k++) {
    const before = performance.now();
    call();
    least = Math.min(least, performance.now() - before);
  }
  return least;
}

/** Operations in a millisecond, `each` in every lane of a step. */
async function rate(numbers, step, each) {
  const { instance } = await WebAssembly.instantiate(arithmetic(numbers, step(numbers)));
  const rounds = 5e4;
  const ms = shortest(() => instance.exports.run(rounds), 1000);
  return (rounds * ACCUMULATORS * numbers.lanes * each) / ms;
}

/**
 * In the page: how many numbers can be added or multiplied in single and in double precision, and
 * divided, in a millisecond.
 */
export const rates = async () => ({
  single: await rate(SINGLE, multiplied, 2),
  double: await rate(DOUBLE, multiplied, 2),
  divisions: await rate(DOUBLE, divided, 1),
});

/** In the page: how many bytes can be read or written in a millisecond, of so many by turns. */
export function bytesPerMs({ bytes }) {
  const half = Math.ceil(bytes / 2);
  const [from, to] = [new Uint8Array(half).fill(1), new Uint8Array(half)];
  // As many that the clock can tell.
  const copies = Math.ceil(4e6 / half);
  const copy = () => {
    for (let k = 0; k < copies; k++) to.set(from);
  };
  return (copies * 2 * half) / shortest(copy, 300);
}
