// What the parts panel says of meshes that are no roof: points, curves, folds, one side, bad coordinates.

import { downloaded, openText, showStep } from '../actions.ts';
import { wavyGrid } from '../meshes.ts';
import { filesOf, openParts, partsPanel } from '../sheets.ts';
import { expect, openPage, test, waitForState } from '../support.ts';

test.use({ sameDocument: true });

const STRANGE: [what: string, text: string, vertices: number, words: RegExp][] = [
  ['points', 'v 0 0 0\nv 1 0 0\nv 0 1 0\n', 3, /no faces: there is nothing to cut/],
  ['an open curve', 'v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 3\n', 3, /no faces: there is nothing to cut/],
  [
    'triangles',
    'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 .5\nf 1 2 3\nf 1 3 4\n',
    4,
    /2 panels on 1 sheet/,
  ],
  [
    'several components',
    'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 5 0 0\nv 6 0 0\nv 6 1 0\nf 1 2 3\nf 4 5 6\n',
    6,
    /2 panels on 1 sheet/,
  ],
  [
    'an edge without length',
    'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 1 1 0\nv 2 0 0\nf 1 2 3 4\nf 2 5 3\n',
    5,
    /2 panels on 1 sheet/,
  ],
  [
    'a coordinate that is not a number',
    'v 0 0 0\nv x 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n',
    4,
    /A coordinate of vertex 1 in the file is not a number/,
  ],
  [
    'a unit that is not known',
    '# units: inches\nv 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 0\nf 1 2 3 4\n',
    4,
    /The unit "inches" is not known/,
  ],
  [
    'a face with a hole beside others',
    `${[0, 4].map((x) => `v ${x} 0 0\nv ${x} 4 0\n`).join('')}v 1 1 0\nv 1 3 0\nv 3 1 0\nv 8 0 0
v 8 4 0\nf 1 3 4 2 1 5 6 7 5\nf 3 8 9 4\n`,
    9,
    /2 panels on 1 sheet.* 1 hole in a panel/,
  ],
  [
    'a face that touches itself beside another',
    'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 2 1 0\nv 2 2 0\nv 0 1 0\nf 1 2 3 4 5 3\nf 1 3 6\n',
    6,
    /1 face has the same vertex at two corners/,
  ],
];
test('drawings are saved if there are faces, else the reason is shown', async ({ page }) => {
  await openPage(page);
  const build = page.getByRole('button', { name: 'Build', exact: true });
  const save = partsPanel(page).getByRole('button', { name: 'Save drawings' });
  for (const [what, text, vertices, words] of STRANGE) {
    await test.step(what, async () => {
      await openText(page, `${what}.obj`, text, vertices);
      await expect(page.getByRole('status')).toContainText(`Opened ${what}.obj`);
      await showStep(page, 'Shape');
      await build.click();
      await expect(partsPanel(page)).toContainText(words);
      if (/no faces|not a number|not known/.test(words.source)) {
        await expect(save).toBeDisabled();
        // The panel is open, although there are no parts.
        await expect(build).toHaveAttribute('aria-pressed', 'true');
      } else {
        const archive = await downloaded(page, () => save.click());
        expect(Object.keys(filesOf(archive.bytes))).toContain('sheet-01.dxf');
      }
      await page.getByRole('button', { name: 'Close build' }).click();
      await expect(partsPanel(page)).toBeHidden();
    });
  }
});

test('folded panels and a one-sided surface show why there is no offset', async ({ page }) => {
  await openPage(page);
  // Moves an inner vertex past its neighbour.
  const folded = wavyGrid(3).split('\n');
  folded[5] = 'v 2.6 2.5 0';
  await openText(page, 'folded.obj', folded.join('\n'), 16);
  const { problems, offset } = await openParts(page);
  expect(offset).toBe(null);
  expect(problems.join()).toContain('folded over');
  await expect(partsPanel(page)).toContainText('folded over');
  await expect(partsPanel(page).getByRole('slider', { name: 'Distance' })).toBeHidden();

  await openText(page, 'one-sided.obj', moebius(8), 16);
  const other = await waitForState(page, (now) => now.build?.panels === 8);
  expect(other.build?.problems.join()).toContain('one side only');
  await expect(partsPanel(page)).toContainText('8 panels on');
});

/** A Möbius strip of quads. */
function moebius(quads: number) {
  const lines = [];
  for (let i = 0; i < quads; i++) {
    const turn = (2 * Math.PI * i) / quads;
    for (const side of [-0.5, 0.5]) {
      const radius = 3 + side * Math.cos(turn / 2);
      const [x, y] = [radius * Math.cos(turn), radius * Math.sin(turn)];
      lines.push(`v ${x.toFixed(6)} ${y.toFixed(6)} ${(side * Math.sin(turn / 2)).toFixed(6)}`);
    }
  }
  const at = (i: number, side: number) => 1 + 2 * (i % quads) + (i < quads ? side : 1 - side);
  for (let i = 0; i < quads; i++)
    lines.push(`f ${at(i, 0)} ${at(i + 1, 0)} ${at(i + 1, 1)} ${at(i, 1)}`);
  return `${lines.join('\n')}\n`;
}
