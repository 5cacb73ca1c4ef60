/** What a drag with each mouse button does to the camera: as in Rhino, on web pages, or in Blender. */

import { CTRL, IS_MAC } from '../../ui/keys.ts';
import type { Mouse } from '../../store/state.ts';

/** What a drag does to the camera. */
export type CameraDrag = 'orbit' | 'pan' | 'zoom';

/** A drag with Shift, with Ctrl, and with neither. */
type Drags = { plain: CameraDrag; shift: CameraDrag; ctrl: CameraDrag };

const all = (plain: CameraDrag): Drags => ({ plain, shift: plain, ctrl: plain });

/** The drags with the middle and the right button; the left one is that of the tool. */
const DRAGS: Record<Mouse, Record<1 | 2, Drags>> = {
  rhino: { 1: all('pan'), 2: { plain: 'orbit', shift: 'pan', ctrl: 'zoom' } },
  web: { 1: all('zoom'), 2: all('pan') },
  blender: {
    1: { plain: 'orbit', shift: 'pan', ctrl: 'zoom' },
    2: { plain: 'orbit', shift: 'pan', ctrl: 'zoom' },
  },
};

/** Returns what a drag with the middle (1) or right (2) button does. */
export function cameraDrag(mouse: Mouse, button: 1 | 2, event: MouseEvent): CameraDrag {
  const drags = DRAGS[mouse][button];
  if (event.shiftKey) return drags.shift;
  // On a Mac the left button with Ctrl is the right one.
  return event.metaKey || (event.ctrlKey && !IS_MAC) ? drags.ctrl : drags.plain;
}

/** What the settings are called, after "as". */
export const MOUSE_NAMES: Record<Mouse, string> = {
  rhino: 'in Rhino',
  web: 'on web pages',
  blender: 'in Blender',
};

/** What the middle and the right button do. */
export const MOUSE_WORDS: Record<Mouse, string> = {
  rhino: `right drag orbits, with ${CTRL} zooms; Shift + right drag and middle drag pan`,
  web: 'right drag pans, middle drag zooms',
  blender: `middle drag orbits, with Shift pans, with ${CTRL} zooms`,
};
