import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { actionOf, isModified, isWritten } from './keyboard';
import { texts } from './texts';

function press(key: string, more: object = {}) {
  return actionOf({
    key,
    shiftKey: false,
    ctrlKey: false,
    metaKey: false,
    altKey: false,
    target: null,
    ...more,
  });
}

describe('a key', () => {
  it.each([
    ['F8', { kind: 'emergencyStop' }],
    [' ', { kind: 'emergencyStop' }],
    ['p', { kind: 'pause' }],
    ['P', { kind: 'pause' }],
    ['.', { kind: 'step' }],
    ['+', { kind: 'faster' }],
    ['-', { kind: 'slower' }],
    ['3', { kind: 'select', robot: 2 }],
    ['0', { kind: 'fit' }],
    ['?', { kind: 'help' }],
    ['Escape', { kind: 'cancel' }],
  ])('%s does what the help says', (key, action) => expect(press(key)).toEqual(action));

  it('moves the map as a hand would push the view', () => {
    expect(press('ArrowLeft')).toMatchObject({ kind: 'pan', dx: 60 });
    expect(press('ArrowUp')).toMatchObject({ kind: 'pan', dy: 60 });
  });

  it('turns the map when it moves it otherwise', () => {
    expect(press('ArrowLeft', { shiftKey: true })).toEqual({ kind: 'turn', by: Math.PI / 12 });
    expect(press('ArrowRight', { shiftKey: true })).toEqual({ kind: 'turn', by: -Math.PI / 12 });
    expect(press('N')).toEqual({ kind: 'upright' });
  });

  it('without a meaning does nothing', () => {
    expect(press('q')).toBeNull();
    expect(press('F5')).toBeNull();
    expect(press('Tab')).toBeNull();
  });

  it('belongs to the browser together with Ctrl, Alt or Cmd', () => {
    expect(press('p', { ctrlKey: true })).toBeNull();
    expect(press('r', { metaKey: true })).toBeNull();
    expect(press('f', { altKey: true })).toBeNull();
  });

  it('is modified by Ctrl, Alt and Cmd, not by Shift', () => {
    const none = { ctrlKey: false, metaKey: false, altKey: false, shiftKey: true };
    expect(isModified(none)).toBe(false);
    expect(isModified({ ...none, metaKey: true })).toBe(true);
    expect(isModified({ ...none, ctrlKey: true })).toBe(true);
    expect(isModified({ ...none, altKey: true })).toBe(true);
  });

  it('stops in an emergency wherever the focus is', () => {
    for (const tagName of ['INPUT', 'TEXTAREA', 'SELECT', 'BUTTON']) {
      expect(press('F8', { target: { tagName, type: 'text' } })).toEqual({ kind: 'emergencyStop' });
    }
  });

  it('stops by the space key unless that belongs to what has the focus', () => {
    for (const target of [null, { tagName: 'DIV' }, { tagName: 'INPUT', type: 'range' }]) {
      expect(press(' ', { target })).toEqual({ kind: 'emergencyStop' });
    }
    for (const target of [
      { tagName: 'BUTTON' },
      { tagName: 'SUMMARY' },
      { tagName: 'SELECT' },
      { tagName: 'INPUT', type: 'text' },
      { tagName: 'INPUT', type: 'checkbox' },
    ]) {
      expect(press(' ', { target })).toBeNull();
    }
  });

  it('belongs to what takes text, but for Escape', () => {
    const input = { target: { tagName: 'INPUT', type: 'search' } };
    expect(press('p', input)).toBeNull();
    expect(press('1', input)).toBeNull();
    expect(press('Escape', input)).toEqual({ kind: 'cancel' });
    expect(press('p', { target: { tagName: 'INPUT', type: 'checkbox' } })).toEqual({ kind: 'pause' });
  });

  it('belongs to the editor, which is in a shadow tree, but for the emergency stop', () => {
    const editor = { target: { tagName: 'DIV', shadowRoot: {} } };
    expect(press(' ', editor)).toBeNull();
    expect(press('p', editor)).toBeNull();
    expect(press('F8', editor)).toEqual({ kind: 'emergencyStop' });
  });

  it('belongs to a slider when it moves it', () => {
    const slider = { target: { tagName: 'INPUT', type: 'range' } };
    expect(press('ArrowLeft', slider)).toBeNull();
    expect(press('-', slider)).toEqual({ kind: 'slower' });
  });
});

it('is known where somebody writes', () => {
  const at = (tagName: string, type = '') => isWritten({ tagName, type } as unknown as EventTarget);
  expect([at('INPUT', 'search'), at('INPUT', 'text'), at('TEXTAREA')]).toEqual([true, true, true]);
  expect([at('INPUT', 'range'), at('INPUT', 'checkbox'), at('SELECT'), at('BODY'), isWritten(null)]).toEqual(
    Array(5).fill(false),
  );
});

it('the documentation has the keys that the help has', () => {
  const page = readFileSync(new URL('../../../docs/reference/page.md', import.meta.url), 'utf8');
  const rows = [...page.matchAll(/^\| (.+) \| (.+) \|$/gm)].map(([, key, meaning]) => [key, meaning]);
  expect(rows.slice(1)).toEqual(texts.help.keys); // after the head
});
