// The page shows its licences and what the LGPL requires.

import { execFileSync } from 'node:child_process';
import { downloaded } from '../actions.ts';
import { expect, openPage, test } from '../support.ts';

test('the help leads to the licences, with the sources to build a changed library', async ({
  page,
}) => {
  await openPage(page);
  await page.getByRole('button', { name: 'Help' }).click();
  const opened = page.waitForEvent('popup');
  await page.getByRole('link', { name: 'Licences' }).click();
  const licences = await opened;
  await expect(licences.getByRole('heading', { name: 'Licences', level: 1 })).toBeVisible();
  for (const name of ['sprs-ldl', 'amd', 'rhino3dm', 'uplot'])
    await expect(licences.getByRole('link', { name, exact: true })).toBeVisible();
  for (const [link, inside] of [
    ['the source of the library', /sprs-ldl-[\d.]+\/src\/lib\.rs/],
    ['the source of Shape-Up', /^\.?\/?src\/lib\.rs$/m],
  ]) {
    const { bytes } = await downloaded(licences, () =>
      licences.getByRole('link', { name: link }).click(),
    );
    expect(execFileSync('tar', ['-tzf', '-'], { input: bytes }).toString()).toMatch(inside);
  }
});
