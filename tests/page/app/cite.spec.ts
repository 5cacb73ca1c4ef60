// Citing: BibTeX entries of the paper and the program, copied from the help with one press.

import { execFileSync } from 'node:child_process';
import { program } from '../../../.scripts/project.mjs';
import { expect, openPage, test } from '../support.ts';

test.use({ permissions: ['clipboard-read', 'clipboard-write'] });

test('the help shows and copies the citations of the paper and the program', async ({ page }) => {
  await openPage(page);
  await page.keyboard.press('?');
  const help = page.getByRole('dialog', { name: 'Mouse and keys' });
  // The version that the command line tells of, too.
  const [, version] = execFileSync(program, ['--version'], { encoding: 'utf8' }).trim().split(' ');
  expect(version).toMatch(/^\d+\.\d+\.\d+$/);
  await expect(help.getByText(`Version ${version}.`)).toBeVisible();
  await help.getByRole('button', { name: 'Cite' }).click();
  const cite = page.getByRole('dialog', { name: 'Cite' });
  await expect(cite.getByText('10.1111/j.1467-8659.2012.03171.x')).toBeVisible();
  await expect(cite.getByText('@software{shapeup')).toContainText(`version = {${version}}`);
  await cite.getByRole('button', { name: 'Copy' }).first().click();
  await expect(cite.getByText('Copied to the clipboard.')).toBeVisible();
  const copied = await page.evaluate(() => navigator.clipboard.readText());
  expect(copied).toMatch(/^@article\{bouaziz2012shapeup,/);
});
