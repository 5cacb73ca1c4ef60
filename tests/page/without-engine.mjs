// For tests that run before the engine is built: it is not there, even if it was built before.

import { register } from 'node:module';

const hooks = `
  export const resolve = (name, context, next) => {
    if (!name.endsWith('pkg/engine/shape_up.js')) return next(name, context);
    throw new Error('tests that ask the engine are in tests/page/engine');
  };`;
register(`data:text/javascript,${encodeURIComponent(hooks)}`);
