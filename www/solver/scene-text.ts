/** What the page reads of the text of a scene with its mesh. What is as by default is left out there. */

type Group = { faces?: number[] | string };

/** The groups of a mesh by name; an array if several share one. */
export type Groups = Record<string, Group | Group[]>;

export type Point = [number, number, number];

export interface SceneText {
  /** symbol of the unit of length; left out if there is none */
  units?: string;
  up?: 'y' | 'z';
  mesh: {
    positions: Point[];
    faces?: number[][];
    /** faces that are left as they are */
    untouched?: number[][];
    curves?: number[][];
    tets?: number[][];
    groups?: Groups;
  };
  variants?: { kept?: { positions: Point[] }[]; design?: number };
  current?: Point[];
}

export const sceneOf = (text: string): SceneText => JSON.parse(text);
