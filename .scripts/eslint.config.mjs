// The lints of TypeScript and JavaScript: mistakes only; Prettier does the layout.

import js from '@eslint/js';
import globals from 'globals';
import ts from 'typescript-eslint';
import { roomRules } from './rooms.mjs';

const typed = ['www/**/*.{ts,tsx}', 'tests/page/**/*.ts'];

export default ts.config(
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
    files: typed,
    extends: [ts.configs.recommendedTypeChecked],
    languageOptions: {
      parserOptions: { project: './tsconfig.json', tsconfigRootDir: import.meta.dirname },
    },
    rules: {
      // JSON of scenes and of files is not typed.
      ...Object.fromEntries(
        ['argument', 'assignment', 'call', 'member-access', 'return'].map((what) => [
          `@typescript-eslint/no-unsafe-${what}`,
          'off',
        ]),
      ),
      // Actions are objects of functions, which are passed on by name; some are asynchronous by their type.
      '@typescript-eslint/unbound-method': 'off',
      '@typescript-eslint/require-await': 'off',
      // What was caught is passed on as it is.
      '@typescript-eslint/prefer-promise-reject-errors': ['error', { allowThrowingUnknown: true }],
      // A handler of an event may be asynchronous: its errors are reported as uncaught ones.
      '@typescript-eslint/no-misused-promises': ['error', { checksVoidReturn: false }],
    },
  },
  {
    // What an address without encryption lacks, where the page works, too.
    files: ['www/**/*.{ts,tsx}'],
    ignores: ['www/ui/output.ts'],
    rules: {
      'no-restricted-properties': [
        'error',
        { object: 'navigator', property: 'clipboard', message: 'Use copyText of ui/output.ts.' },
        { object: 'crypto', property: 'randomUUID', message: 'It is missing without encryption.' },
      ],
    },
  },
  {
    files: ['tests/page/**/*.ts'],
    rules: {
      '@typescript-eslint/no-floating-promises': [
        'error',
        { allowForKnownSafeCalls: [{ from: 'package', name: 'test', package: 'node:test' }] },
      ],
      // Messages of assertions, and functions that are sent to the page as text.
      '@typescript-eslint/restrict-template-expressions': 'off',
      '@typescript-eslint/no-base-to-string': 'off',
      '@typescript-eslint/no-implied-eval': 'off',
    },
  },
  {
    // The types of the library lack most constructors.
    files: ['www/documents/rhino/*.ts', 'tests/page/documents/rhino-objects.test.ts'],
    rules: { '@typescript-eslint/no-explicit-any': 'off' },
  },
  ...roomRules,
  {
    // They run in Node, except the functions that they evaluate in a page.
    files: ['tests/**/*.mjs', '.scripts/**/*.{mjs,js}'],
    languageOptions: { globals: { ...globals.node, ...globals.browser } },
  },
  { files: ['.scripts/**/*.mjs'], rules: { 'no-console': 'off' } },
);
