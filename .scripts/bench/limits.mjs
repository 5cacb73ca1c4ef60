// What the machine can do at best in the browser, beside what the global step takes.

/** Accumulators of the loop, lanes of each, and operations on a lane: a multiplication and an addition. */
const [ACCUMULATORS, LANES, OPERATIONS] = [8, 4, 2];

/** A module with one function: multiplies and adds in registers, `n` times in all accumulators. */
function arithmetic() {
  const [get, set, tee] = [0x20, 0x21, 0x22];
  const [splat, extract] = [
    [0xfd, 0x13],
    [0xfd, 0x1f, 0],
  ];
  const [add, multiply] = [
    [0xfd, 0xe4, 0x01],
    [0xfd, 0xe6, 0x01],
  ];
  // Local 0 is n, local 1 the factor 0.5 in all lanes, which is added, too.
  const own = Array.from({ length: ACCUMULATORS }, (_, k) => 2 + k);
  const step = (a) => [get, a, get, 1, ...multiply, get, 1, ...add, set, a];
  const loop = [0x03, 0x40, ...own.flatMap(step), get, 0, 0x41, 1, 0x6b, tee, 0, 0x0d, 0, 0x0b];
  // All are read in the end, or the engine would leave them out.
  const [first, ...others] = own;
  const total = [get, first, ...others.flatMap((a) => [get, a, ...add]), ...extract];
  const half = [0x43, 0, 0, 0, 0x3f, ...splat, set, 1];
  const body = [1, 1 + ACCUMULATORS, 0x7b, ...half, ...loop, ...total, 0x0b];
  const sized = (bytes) => {
    const [low, high] = [bytes.length & 127, bytes.length >> 7];
    return [...(high ? [low | 128, high] : [low]), ...bytes];
  };
  const sections = [
    [1, [1, 0x60, 1, 0x7f, 1, 0x7d]],
    [3, [1, 0]],
    [7, [1, ...sized([...'run'].map((letter) => letter.charCodeAt())), 0, 0]],
    [10, [1, ...sized(body)]],
  ];
  const magic = [0, 0x61, 0x73, 0x6d, 1, 0, 0, 0];
  return Uint8Array.from([...magic, ...sections.flatMap(([id, bytes]) => [id, ...sized(bytes)])]);
}

function repeat(count, call) {
  for (let k = 0; k < count; k++) call();
}

/** The shortest of some calls, in milliseconds: what the machine can do when nothing interrupts it. */
function shortest(call) {
  let least = Infinity;
  for (let [k, start] = [0, performance.now()]; k < 5 || performance.now() - start < 200; k++) {
    const before = performance.now();
    call();
    least = Math.min(least, performance.now() - before);
  }
  return least;
}

/**
 * In the page: what a solve with a factor of so many numbers takes at least, in milliseconds. It is
 * read forwards and backwards, which moves as many bytes as a copy of it; and each number is
 * multiplied and added both times, for three coordinates.
 */
export async function limits({ nonzeros }) {
  const [from, to] = [new Float32Array(nonzeros).fill(1), new Float32Array(nonzeros)];
  // As many that the clock can tell.
  const copies = Math.ceil(1e6 / nonzeros);
  const moved = shortest(() => repeat(copies, () => to.set(from))) / copies;
  const { instance } = await WebAssembly.instantiate(arithmetic());
  const rounds = 1e6;
  const ms = shortest(() => instance.exports.run(rounds));
  const perMs = (rounds * ACCUMULATORS * LANES * OPERATIONS) / ms;
  const operations = 2 * 3 * OPERATIONS * nonzeros;
  return { moved, computed: operations / perMs, perSecond: perMs / 1e6 };
}

/** Measures a problem: the limits beside the global step of the default, whose factor is of such numbers. */
export async function measureLimits(problem, on) {
  const nonzeros = await on('native', 'nonzeros', problem);
  const { moved, computed, perSecond } = await on('browser', 'limits', { ...problem, nonzeros });
  const { global } = (await on('browser', 'iterations', problem))['quasi-newton'];
  const MB = (8 * nonzeros) / 1e6;
  const times = global / Math.max(moved, computed);
  return { vertices: problem.vertices, limit: { MB, moved, computed, perSecond, global, times } };
}
