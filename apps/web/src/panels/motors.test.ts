import { expect, it } from 'vitest';
import { motorsOff } from './motors';

it.each([
  [false, [], [], null, null],
  [true, ['a', 'b'], [], 'Motors are off. Press Arm to switch them on.', 'Arm'],
  [
    true,
    ['a', 'b'],
    ['b'],
    'Motors are off. Press Arm to switch them on. b was switched off separately, and stays off.',
    'Arm',
  ],
  [false, ['a', 'b'], [], 'Motors of a, b are off.', 'Arm all'],
  [
    false,
    ['a', 'b', 'c'],
    ['b', 'c'],
    'Motors of a are off. b, c were switched off separately, and stay off.',
    'Arm the others',
  ],
  [false, ['b'], ['b'], 'Motors of b are off until they are switched on by its card.', null],
  [
    false,
    ['a', 'b', 'c', 'd'],
    ['a', 'b', 'c', 'd'],
    'Motors of 4 robots are off until they are switched on by their cards.',
    null,
  ],
])('all %s, of %j, switched off alone %j: %s (%s)', (all, of, switchedOff, words, arm) =>
  expect(motorsOff({ all, of, switchedOff })).toEqual(words === null ? null : { words, arm }),
);
