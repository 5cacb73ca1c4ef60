// The panel of variations, opened and closed.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Variations } from '../../../www/features/variations/variations.ts';
import { createStore } from '../../../www/store/state.ts';
import type { AppContext } from '../../../www/app/context.ts';

test('a panel that is closed while it is being opened leaves no subscription', async () => {
  const store = createStore();
  let subscriptions = 0;
  const counted = {
    ...store,
    subscribe: (...what: Parameters<typeof store.subscribe>) => {
      const stop = store.subscribe(...what);
      subscriptions++;
      return () => {
        subscriptions--;
        stop();
      };
    },
  };
  const variations = new Variations({ store: counted } as unknown as AppContext);
  // Nothing is open: the panel is closed. As an effect of a component, it then ends what it has begun.
  // It was told before there was anything to end.
  let stop: (() => void) | null = null;
  let isClosed = false;
  stop = variations.begin(() => {
    isClosed = true;
    stop?.();
  });
  await Promise.resolve();
  assert.equal(isClosed, true);
  assert.equal(subscriptions, 0);
});
