// The JavaScript lints: mistakes only; Prettier does the layout.

import js from '@eslint/js';
import globals from 'globals';
import { roomRules } from './rooms.mjs';

export default [
  { ignores: ['dist/', 'target/', 'www/pkg/', 'www/examples/', 'test-results/'] },
  js.configs.recommended,
  {
    linterOptions: { reportUnusedDisableDirectives: 'error' },
    rules: {
      eqeqeq: 'error',
      'no-var': 'error',
      'prefer-const': 'error',
      'no-console': ['error', { allow: ['warn', 'error'] }],
    },
  },
  {
    files: ['www/**/*.js'],
    languageOptions: { globals: { ...globals.browser, ...globals.worker } },
  },
  ...roomRules,
  {
    // They run in Node, except the functions that they evaluate in a page.
    files: ['tests/**/*.mjs', '.scripts/**/*.mjs'],
    languageOptions: { globals: { ...globals.node, ...globals.browser } },
  },
  { files: ['.scripts/**/*.mjs'], rules: { 'no-console': 'off' } },
];
