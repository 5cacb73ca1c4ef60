// What a link contains and unpacks to; a link that was cut or changed is refused.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { deflateRawSync } from 'node:zlib';
import { crc32 } from '../../../www/documents/packing.ts';
import { MOST_BYTES } from '../../../www/documents/packing.ts';
import { linkTo, readLink, writeLink } from '../../../www/documents/share-link.ts';
import type { AppContext } from '../../../www/app/context.ts';
import type { Example } from '../../../www/documents/files.ts';
import { wavyGrid } from '../meshes.ts';

const TOLERANCE = 0.001;
const LETTERS = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.~!';

interface Mesh {
  positions: number[][];
  faces: number[][];
  curves?: number[][];
  tets?: number[][];
  groups?: Record<string, { faces: string }>;
}

/** The parts of a scene file that some tests add. */
interface More {
  title?: string;
  handles?: { vertices: number[]; targets: number[][] }[];
  lesson?: { text: string; goals: object[] };
  weights?: { close: number };
}

/** A scene file; its mesh is in it, or in a file of an example. */
interface Scene<Meshes = Mesh | { file: string }> extends More {
  format: 'shape-up-scene';
  version: number;
  mesh: Meshes;
  constraints: { kind: string; on: string }[];
}

type How = Parameters<typeof writeLink>[1];

/** The mesh of an OBJ file of vertices and faces. */
function meshOf(obj: string): Mesh {
  const words = obj.split('\n').map((line) => line.split(' '));
  const rows = (name: string) =>
    words.filter(([word]) => word === name).map(([, ...values]) => values.map(Number));
  return {
    positions: rows('v'),
    faces: rows('f').map((row) => row.map((index) => index - 1)),
  };
}

const sceneWith = <Given extends Scene['mesh']>(mesh: Given, more: More = {}): Scene<Given> => ({
  format: 'shape-up-scene',
  version: 1,
  mesh,
  constraints: [{ kind: 'plane', on: 'faces' }],
  ...more,
});

const linkOf = (scene: Scene, how: Partial<How> = {}) =>
  writeLink(JSON.stringify(scene), {
    ...{ example: undefined, original: null, run: true, tolerance: TOLERANCE },
    ...how,
  });

/** Reads a link of this page. */
async function read(fragment: string) {
  const linked = await readLink(fragment);
  assert.ok(linked, `not a link: ${fragment}`);
  return linked;
}

/** The scene in a link that has its mesh. */
const opened = async (fragment: string) =>
  JSON.parse((await read(fragment)).text ?? '') as Scene<Mesh>;

/** Returns a generator of the same numbers in every run. */
function numbers(seed: number) {
  let state = seed;
  return () => (state = (state * 1103515245 + 12345) % 2 ** 31) / 2 ** 31;
}

test('a small scene is restored exactly from its link', async () => {
  const scene = sceneWith(meshOf(wavyGrid(4)), { title: 'Dach ✓' });
  const { fragment, rounded } = await linkOf(scene);
  assert.equal(rounded, null);
  assert.deepEqual(await opened(fragment), scene);
  assert.equal((await read(fragment)).run, true);
});

test('a link of 900 panels has at most 3,000 characters, rounded to 1 % of the tolerance', async () => {
  const mesh = meshOf(wavyGrid(30));
  const scene = sceneWith(
    { ...mesh, groups: { east: { faces: '0-99' } } },
    { handles: [{ vertices: [7], targets: [[0.123456789, 2, 3]] }] },
  );
  const { fragment, rounded } = await linkOf(scene);
  assert.equal(mesh.faces.length, 900);
  assert.ok(fragment.length <= 3000, `${fragment.length} characters`);
  assert.ok(rounded !== null && rounded > 0 && rounded <= TOLERANCE / 100);
  const back = await opened(fragment);
  const { mesh: found, handles } = back;
  assert.deepEqual(found.faces, mesh.faces);
  assert.deepEqual(found.groups, scene.mesh.groups);
  found.positions.flat().forEach((value, i) => {
    assert.ok(Math.abs(value - mesh.positions.flat()[i]) <= rounded / 2 + 1e-12);
  });
  assert.deepEqual(handles, [{ vertices: [7], targets: [[0.12346, 2, 3]] }]);
  assert.deepEqual({ ...back, mesh: null, handles: null }, { ...scene, mesh: null, handles: null });
});

/** The same grid with vertices moved at random by up to a fifth of an edge. */
function unevenGrid(n: number): Mesh {
  const random = numbers(3);
  const { positions, faces } = meshOf(wavyGrid(n));
  return { positions: positions.map((at) => at.map((x) => x + 0.4 * random() - 0.2)), faces };
}

test('a link of 900 uneven panels has at most 10,000 characters', async () => {
  const { fragment } = await linkOf(sceneWith(unevenGrid(30)));
  assert.ok(fragment.length <= 10_000, `${fragment.length} characters`);
});

test('curves and tetrahedra are restored with the faces', async () => {
  const mesh = {
    ...meshOf(wavyGrid(20)),
    curves: [
      [0, 1, 2, 0],
      [5, 3],
      [7, 8, 9],
    ],
  };
  for (const scene of [
    sceneWith(mesh),
    sceneWith({
      ...mesh,
      tets: [
        [0, 1, 2, 30],
        [4, 3, 2, 1],
      ],
    }),
    sceneWith({ ...mesh, faces: [], curves: undefined, tets: [[9, 1, 2, 30]] }),
  ]) {
    const { fragment, rounded } = await linkOf(scene);
    assert.ok(rounded !== null && rounded > 0);
    const back = await opened(fragment);
    assert.deepEqual(
      { ...back, mesh: { ...back.mesh, positions: null } },
      JSON.parse(JSON.stringify({ ...scene, mesh: { ...scene.mesh, positions: null } })),
    );
  }
});

test('any mesh is restored with its vertices and faces in their order', async () => {
  const random = numbers(7);
  for (let turn = 0; turn < 60; turn++) {
    const vertices = 150 + Math.floor(random() * 200);
    const scale = 10 ** Math.floor(random() * 9 - 4);
    const far = turn % 3 === 0 ? 1e6 * scale : 0;
    const flat = turn % 4 === 0;
    const positions = Array.from({ length: vertices }, () =>
      [random(), random(), flat ? 0 : random()].map((value) => far + value * scale),
    );
    const faces = Array.from({ length: Math.floor(random() * 300) + 1 }, () => {
      const face = new Set<number>();
      const corners = 3 + Math.floor(random() * 5);
      while (face.size < corners) face.add(Math.floor(random() * vertices));
      return [...face];
    });
    const step = 10 ** -Math.floor(5 + random() * 3) * scale;
    const { fragment, rounded } = await linkOf(sceneWith({ positions, faces }), {
      tolerance: 100 * step,
    });
    assert.ok(rounded !== null, `turn ${turn} is not rounded`);
    const { mesh } = await opened(fragment);
    assert.deepEqual(mesh.faces, faces);
    mesh.positions.flat().forEach((value, i) => {
      const error = Math.abs(value - positions.flat()[i]);
      assert.ok(error <= 0.5001 * rounded + 1e-15 * far, `turn ${turn}: ${error} of ${rounded}`);
    });
  }
});

test('vertices that rounding would merge, lessons, and meshes without a tolerance stay exact', async () => {
  const mesh = meshOf(wavyGrid(20));
  const close = structuredClone(mesh);
  close.positions[5] = close.positions[4].map((value) => value + 1e-9);
  for (const [scene, how] of [
    [sceneWith(close), {}],
    [sceneWith(mesh, { lesson: { text: 'Flat!', goals: [] } }), {}],
    [sceneWith(mesh), { tolerance: 0 }],
  ] satisfies [Scene, Partial<How>][]) {
    const { fragment, rounded } = await linkOf(scene, how);
    assert.equal(rounded, null);
    assert.deepEqual(await opened(fragment), scene);
  }
});

test('every shortened link, and every link with a changed character, is refused', async () => {
  const small = await linkOf(sceneWith(meshOf(wavyGrid(1))));
  const rounded = await linkOf(sceneWith(meshOf(wavyGrid(12))));
  for (const { fragment } of [small, rounded]) {
    const start = '#link='.length;
    for (let end = start; end < fragment.length; end++)
      await assert.rejects(readLink(fragment.slice(0, end)), /incomplete or damaged/);
    for (let at = start; at < fragment.length; at++)
      for (const other of fragment === small.fragment ? LETTERS : 'Aq-.') {
        if (other === fragment[at]) continue;
        const changed = fragment.slice(0, at) + other + fragment.slice(at + 1);
        await assert.rejects(readLink(changed), /incomplete or damaged/);
      }
    await assert.rejects(readLink(`${fragment}.`), /incomplete or damaged/);
  }
});

/** Returns the fragment of a link with this version and deflated content. */
function linkWith(version: number, content: Uint8Array) {
  const bytes = Buffer.concat([Buffer.from([version]), content, Buffer.alloc(4)]);
  bytes.writeUInt32BE(crc32(bytes.subarray(0, -4)), bytes.length - 4);
  return `#link=${bytes.toString('base64url')}`;
}

test('links of other versions are refused, and the message says what to do', async () => {
  const scene = JSON.stringify(sceneWith(meshOf(wavyGrid(3))));
  const content = deflateRawSync(Buffer.from(JSON.stringify({ scene })));
  for (const version of [7, 9])
    await assert.rejects(readLink(linkWith(version, content)), /another version of this page/);
  assert.equal(await readLink('#scene=!'), null);
});

test('an example is stored by its name, and edits in the code', async () => {
  const example = { id: 'hypar', mesh: 'hypar.obj' } as Example;
  const original = JSON.stringify(sceneWith({ file: 'hypar.obj' }));
  const how = { example, original, run: false };
  const plain = await linkOf(JSON.parse(original), how);
  assert.equal(plain.fragment, '#example=hypar');
  const edited = sceneWith({ file: 'hypar.obj' }, { weights: { close: 3 } });
  const { fragment } = await linkOf(edited, how);
  assert.deepEqual(await readLink(fragment), {
    ...{ example: 'hypar', text: JSON.stringify(edited), run: false, name: null },
  });
});

test('an example whose mesh was refined is stored with that mesh, also when it was resumed', async (context) => {
  // The link used to name the example's mesh: constraints and handles lay on vertices it lacks.
  context.after(() => Reflect.deleteProperty(globalThis, 'location'));
  globalThis.location = { href: 'https://shape-up.test/#example=roof' } as Location;
  const obj = `# roof\n${wavyGrid(2)}`;
  const appWith = (mesh: Mesh, original: Mesh | null) =>
    ({
      store: { get: () => ({ document: { tolerance: TOLERANCE } }) },
      actions: { ask: { scene: async () => JSON.stringify(sceneWith(mesh)) } },
      files: {
        origin: { example: { id: 'roof', mesh: 'roof.obj' } },
        original: original && JSON.stringify(sceneWith(original)),
        exampleFile: async () => new TextEncoder().encode(obj),
      },
    }) as unknown as AppContext;
  const hashOf = async (mesh: Mesh, original: Mesh | null) =>
    new URL((await linkTo(appWith(mesh, original))).address).hash;
  const [mesh, refined] = [meshOf(obj), meshOf(wavyGrid(4))];
  assert.equal(await hashOf(mesh, mesh), '#example=roof');
  assert.equal((await read(await hashOf(mesh, null))).example, 'roof');
  for (const original of [mesh, null]) {
    const hash = await hashOf(refined, original);
    assert.equal((await read(hash)).example, null);
    assert.deepEqual((await opened(hash)).mesh, refined);
  }
});

test('data that unpacks to more than the limit is refused without blocking the page', async () => {
  const bomb = deflateRawSync(Buffer.alloc(MOST_BYTES * 2));
  let turns = 0;
  const timer = setInterval(() => (turns += 1), 1);
  await assert.rejects(readLink(linkWith(8, bomb)), /more than 32 MB. Ask .* for the scene file/);
  clearInterval(timer);
  assert.ok(turns >= 10, `${turns} turns while it was unpacked`);
});
