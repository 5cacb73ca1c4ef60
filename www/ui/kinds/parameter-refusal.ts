/** An error of the solver at the parameter that it is about. */

import { useState } from 'preact/hooks';
import type { Param } from '../../pkg/engine/shape_up.js';

export interface Refusal {
  /** the parameter; empty if it is about several */
  id: string;
  /** index of the number in its value */
  place: number;
  message: string;
}

/** Reads an error with a `path` in the scene; null if it is about something else. */
function atParameter(error: unknown, params: Param[]): Refusal | null {
  if (!(error instanceof Error && 'path' in error)) return null;
  const at = String(error.path);
  const path = at.replace(/^constraints\[\d+\]\.?/, '');
  const message = error.message.replace(`${at}: `, '');
  const [, id = '', place = '0'] = /^([^.[]*)(?:\[(\d+)\])?/.exec(path) ?? [];
  if (path !== '' && !params.some((param) => param.id === id)) return null;
  return { id: path === '' ? '' : id, place: Number(place), message };
}

/** The last refusal of a change of these parameters. */
export function useRefusal(params: Param[]) {
  const [refusal, setRefusal] = useState<Refusal | null>(null);
  return {
    refusal,
    /** Keeps an error; returns whether it is about these parameters. */
    refuse(error: unknown) {
      const found = atParameter(error, params);
      if (found) setRefusal(found);
      return found !== null;
    },
    /** Forgets it, as what is asked now is something else. */
    forget: () => setRefusal(null),
  };
}
