import js from '@eslint/js';
import svelte from 'eslint-plugin-svelte';
import globals from 'globals';
import ts from 'typescript-eslint';
import svelteConfig from './svelte.config.js';

export default ts.config(
  { ignores: ['dist/', 'target/', 'node_modules/'] },
  js.configs.recommended,
  ...ts.configs.strict,
  ...svelte.configs.recommended,
  {
    languageOptions: { globals: { ...globals.browser, ...globals.node } },
    rules: { '@typescript-eslint/no-non-null-assertion': 'off' }, // indices in loops are known to be there
  },
  {
    files: ['**/*.svelte', '**/*.svelte.ts'],
    languageOptions: { parserOptions: { parser: ts.parser, svelteConfig } },
  },
  {
    // what people read is in one place
    files: ['src/**'],
    ignores: ['src/texts.ts', 'src/**/*.test.ts'],
    rules: {
      'no-restricted-syntax': [
        'error',
        ...[
          ':not(SvelteStyleElement) > SvelteText[value=/[A-Za-z]{2}/]',
          'SvelteAttribute[key.name=/^(alt|aria-label|label|placeholder|title)$/] > SvelteLiteral[value=/[A-Za-z]{2}/]',
          ':not(NewExpression[callee.name="Error"]) > Literal[value=/^[A-Z][a-z]*( [a-z]+){2}/]',
          'TemplateElement[value.raw=/[a-z]+( [a-z]+){2}/]',
        ].map((selector) => ({ selector, message: 'This text belongs to src/texts.ts.' })),
      ],
    },
  },
);
