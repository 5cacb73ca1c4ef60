/** The docked panel of parts: settings, the build check, the sheets and their files. */

import './build-panel.css';
import { askRhino } from '../../documents/rhino/rhino-client.ts';
import { docked } from '../../docked/docked.ts';
import { button, closeButton } from '../../ui/controls/fields.ts';
import { element } from '../../ui/dom.ts';
import { oneAtATime } from '../../ui/once.ts';
import { latestOnly, MOST_LIVE_VERTICES } from '../../store/latest-only.ts';
import { showElements } from '../../viewport/camera.ts';
import { checkCard } from './check-card.ts';
import { showReport } from './report/dialog-report.ts';
import { LiveBuild, MOST_SHEETS } from './live-build.ts';
import { offsetLayer } from './offset-layer.ts';
import { settingsForm } from './settings-form.ts';
import { panelUnderPointer } from './sheets/panel-under-pointer.ts';
import { sheetPictures } from './sheets/sheet-pictures.ts';
import { thicknessForm } from './thickness.ts';
import { typesCurve } from './types-curve.ts';
import type { BuildReport, BuildSettings, Built, CheckRow, Reshaped } from '../../solver/types.ts';
import type { AppContext } from '../../app/context.ts';

/** Colour of the panels of the part pointed at on a sheet. */
const POINTED: [number, number, number] = [230, 120, 20];

let only: { toggle: () => void } | null = null;

export async function toggleBuild(app: AppContext) {
  only ??= await buildPanel(app);
  only.toggle();
}

async function buildPanel(app: AppContext) {
  const { store, actions, files } = app;
  const live = new LiveBuild(app, 'panel', { show, showOffset, refuse });
  const offers = await live.offers();
  const form = settingsForm(offers, change);
  const check = checkCard(showWorst, tighten);
  const thickness = thicknessForm(offers.settings, {
    tryDistance: (distance) => tried.ask(distance),
    restore: () => tried.ask(null),
    change,
  });
  const types = typesCurve(change);
  const layer = offsetLayer(app);
  // Without a distance, the parts have that of the settings again.
  const tried = latestOnly((distance: number | null) =>
    actions.reportErrors(
      distance === null ? live.again() : live.moveLayer(distance).then(showOffset),
    ),
  );
  const pictures = sheetPictures({
    point: (panels) =>
      actions.tint(
        panels && {
          ...{ faces: Uint32Array.from(panels), vertices: new Uint32Array(0) },
          colour: POINTED,
        },
      ),
    choose: (panels) => actions.select({ vertices: [], faces: panels }),
  });
  panelUnderPointer(app.viewport, {
    isAsked: () => !panel.hidden,
    point: (face) => pictures.pointAtPanel(face),
    press: () => pictures.revealPointed(),
  });
  const words = element('p', { 'aria-live': 'polite' });
  const notes = element('div');
  const save = button('Save drawings and tables', saveAll, { class: 'primary' });
  const rhino = button('Rhino', () => actions.reportErrors(saveForRhino()), {
    title: 'Panels, beams, nodes and sheets as layers of a .3dm file',
  });
  const open = oneAtATime(() => showReport(app, live));
  const report = button('Report', () => actions.reportErrors(open()));
  const panel = element(
    'section.docked',
    { id: 'parts-panel', 'aria-labelledby': 'heading-parts', hidden: true },
    element(
      'div.heading-row',
      element('h2', { id: 'heading-parts' }, 'Parts and sheets'),
      words,
      report,
      rhino,
      save,
      closeButton('Close parts and sheets', () => place.close()),
    ),
    element(
      'div.docked-columns.parts-columns',
      form.form,
      element('div.parts-check', thickness.place, check.card, types.place, notes),
      pictures.place,
    ),
  );

  /** Shows what depends on the offset and follows a drag. */
  function showOffset(built: Reshaped) {
    if (panel.hidden || !built) return;
    check.update(built, store.get());
    thickness.update(built, live.settings(), live.unit().metres);
    layer.show(built.layer);
  }

  function show({ report: found, words: said, sheets, layer }: Built) {
    if (panel.hidden) return;
    actions.look({ build: found });
    check.card.hidden = false;
    words.textContent = said.sheets;
    showOffset({ report: found, words: said.card, layer });
    types.update(found, said.joint, live.settings());
    notes.replaceChildren(...said.warnings.map((line) => element('p.notice', line)));
    pictures.show(sheets, new Set(layer.panels), Math.max(0, found.sheets - MOST_SHEETS));
    pictures.mark(store.get().selection.faces);
    save.disabled = rhino.disabled = report.disabled = false;
    void actions.reportErrors(offerKinds());
  }

  /** Shows the error of each kind of offset, while the shape is at rest. */
  async function offerKinds() {
    const { running, dragged, model } = store.get();
    if (!running && !dragged.length && (model?.vertices ?? 0) <= MOST_LIVE_VERTICES)
      thickness.offer(await live.choices());
  }

  function refuse(why: string) {
    words.textContent = '';
    notes.replaceChildren(element('p.notice', why));
    pictures.show([], new Set(), 0);
    layer.show(null);
    actions.look({ build: null });
    for (const own of [check.card, thickness.place, types.place]) own.hidden = true;
    save.disabled = rhino.disabled = report.disabled = true;
  }

  /** What was sent and is not in the scene yet, and the number of edits that this takes. */
  let sent: Partial<BuildSettings> = {};
  let pending = 0;

  function change(own: Partial<BuildSettings>) {
    sent = { ...sent, ...own };
    pending += 1;
    const build = { ...store.get().document?.build, ...sent };
    void actions.edit({ setBuild: { build } }).then((edited) => {
      pending -= 1;
      // What was refused is neither sent again nor shown any longer.
      if (edited === undefined) form.show(live.settings(), live.unit().symbol);
      if (!pending || edited === undefined) sent = {};
    });
  }

  function showWorst(worst: CheckRow['worst']) {
    if (worst === 'none') return;
    if ('panel' in worst) showElements(app, { vertices: [], faces: [worst.panel] });
    else showElements(app, { vertices: 'edge' in worst ? worst.edge : [worst.vertex], faces: [] });
  }

  function tighten({ constraint, within }: BuildReport['tighten']['suggestions'][number]) {
    return actions.makePanels(constraint, within);
  }

  async function saveAll() {
    const bytes = await actions.reportErrors(live.zip());
    if (bytes) files.save('-parts.zip', bytes, 'application/zip');
  }

  /** Saves a 3DM file, loading its large writer. */
  async function saveForRhino() {
    const [parts, { symbol }] = [await live.spatialParts(), live.unit()];
    const bytes = await askRhino((rhino) => rhino.writeParts(parts, symbol));
    files.save('-parts.3dm', bytes, 'model/vnd.3dm');
  }

  const place = docked(panel, {
    opened() {
      form.show(live.settings(), live.unit().symbol);
      void live.again();
      panel.querySelector('select')?.focus();
    },
    closed() {
      layer.show(null);
      actions.tint(null);
      actions.look({ build: null });
    },
  });

  store.subscribe(
    ['document', 'numbers', 'running', 'dragged', 'model'],
    ({ document: scene, model }) => {
      if (panel.hidden) return;
      if (!model) return place.close();
      if (!scene) return;
      form.show(live.settings(), live.unit().symbol);
      void live.update();
    },
  );
  store.subscribe(['selection'], ({ selection }) => {
    if (!panel.hidden) pictures.mark(selection.faces);
  });
  return place;
}
