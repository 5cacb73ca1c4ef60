/** The poster of an embedded view until the user starts it: a picture, a button and a link. */

import { readLink } from '../../documents/share-link.ts';
import { exampleOf, listOfExamples } from '../../solver/examples.ts';
import { messageOf } from '../../solver/errors.ts';
import { sceneOf, type SceneText } from '../../solver/scene-text.ts';
import { byId, setText } from '../../ui/dom.ts';
import { drawShape } from '../../ui/plot/thumbnail.ts';
import { PRESSED } from '../../ui/embedded.ts';

const { hash, search } = location;
byId<HTMLAnchorElement>('home').href = `./${hash}`;
byId('start').addEventListener('click', () => start(PRESSED));
if (new URLSearchParams(search).has('autoplay')) start();

readLink(hash).then(
  (link) =>
    link?.example
      ? showExample(link.example, link.run && !link.text ? 'end' : 'start')
      : showScene(link?.text ?? null, link?.name ?? 'A model in Shape-Up'),
  (error) => setText(byId('trouble'), messageOf(error)),
);

/**
 * Replaces this page by the view, with the same options.
 * @param embed how it was started; a view that nobody pressed leaves the wheel to the page around it
 */
function start(embed = '') {
  const options = new URLSearchParams(search);
  options.set('embed', embed);
  location.replace(`./?${options}${hash}`);
}

/** Draws the mesh of a scene as it is in the text, which is seldom solved. */
function showScene(text: string | null, name: string) {
  setText(byId('title'), name);
  if (!text) return;
  const { mesh, current, up = 'z' } = sceneOf(text);
  const drawn = drawnOf(mesh);
  let end = 0;
  const faceOffsets = Uint32Array.from([0, ...drawn.map(({ length }) => (end += length))]);
  const drawing = byId<HTMLCanvasElement>('drawing');
  drawing.hidden = drawn.length === 0;
  const faceIndices = Uint32Array.from(drawn.flat());
  drawShape(drawing, { faceOffsets, faceIndices }, (current ?? mesh.positions).flat(), { up });
}

/** What is drawn of a mesh, each by its corners: faces and segments of curves, or else the points. */
function drawnOf({ faces = [], tets = [], curves = [], positions }: SceneText['mesh']) {
  const ofTets = tets.flatMap((tet) => tet.map((_, left) => tet.filter((_, k) => k !== left)));
  const segments = curves.flatMap((curve) => curve.slice(1).map((to, k) => [curve[k], to]));
  const drawn = [...faces, ...ofTets, ...segments];
  return drawn.length > 0 ? drawn : positions.map((_, point) => [point]);
}

/** @param pose in which Start opens it */
async function showExample(id: string, pose: 'start' | 'end') {
  try {
    const example = exampleOf(await listOfExamples(), id);
    setText(byId('title'), example.title);
    const picture = byId<HTMLImageElement>('picture');
    picture.src = `pictures/${example.id}-${pose}.webp`;
    picture.alt = example.title;
    picture.hidden = false;
  } catch (error) {
    setText(byId('trouble'), messageOf(error));
  }
}
