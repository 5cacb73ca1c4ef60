/** The parts of the page, for every component. */

import { createContext } from 'preact';
import { useContext } from 'preact/hooks';
import type { AppContext } from '../app/context.ts';

const Provided = createContext<AppContext | null>(null);

/** Gives the parts of the page to the components inside. */
export const AppProvider = Provided.Provider;

/** The parts of the page; a component that reads `store.state` is rendered again when it changes. */
export function useApp(): AppContext {
  const app = useContext(Provided);
  if (!app) throw new Error('a component is outside of the page');
  return app;
}
