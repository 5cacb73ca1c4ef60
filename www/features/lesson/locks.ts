/** Disables what a lesson locks, and shows the reason. The session also refuses such edits. */

import { byId, element } from '../../ui/dom.ts';
import type { LessonWords } from '../../solver/types.ts';

type Lock = LessonWords['lock'][number];

/** Lockable parts of the page. */
const PLACES: { lock: Lock; id: string; words: string }[] = [
  { lock: 'mesh', id: 'model', words: 'the mesh stays as it is' },
  { lock: 'weights', id: 'energies', words: 'the weights stay as they are' },
  { lock: 'constraints', id: 'add-constraint-button', words: '' },
  { lock: 'constraints', id: 'constraints', words: 'the constraints stay as they are' },
  { lock: 'constraints', id: 'make-panels', words: '' },
  { lock: 'constraints', id: 'make-panels-card', words: '' },
  { lock: 'handles', id: 'handles', words: 'the handles stay as they are' },
];

/** The locks in display order. */
export const LOCKS: [Lock, string][] = [
  ['mesh', 'Mesh'],
  ['constraints', 'Constraints'],
  ['weights', 'Weights'],
  ['handles', 'Handles'],
];

export const locksInWords = (lock: readonly Lock[]) =>
  LOCKS.filter(([id]) => lock.includes(id))
    .map(([, label]) => label.toLowerCase())
    .join(', ');

/** Returns a function that shows the locks of a lesson. */
export function lockedPlaces() {
  const places = PLACES.map(({ lock, id, words }) => {
    const place = byId(id);
    const note = element('p.locked-note.quiet', { id: `${id}-locked`, hidden: true });
    note.textContent = words && `Locked by the lesson: ${words}.`;
    // A fieldset also disables controls that are added later.
    const set = element('fieldset.locked', words && { 'aria-describedby': note.id });
    place.before(...(words ? [note, set] : [set]));
    set.append(place);
    return { lock, note, set };
  });
  return (locked: readonly Lock[]) => {
    for (const { lock, note, set } of places) {
      set.disabled = locked.includes(lock);
      set.title = set.disabled ? 'Locked by the lesson' : '';
      note.hidden = !set.disabled || !note.textContent;
    }
  };
}
