import { describe, expect, it } from 'vitest';
import { entriesOf, entryAt, placeAt, type Place } from './yaml';

/** Where one is at the `|` in a text. */
function at(text: string): Place | null {
  const offset = text.indexOf('|');
  return placeAt(text.replace('|', ''), offset);
}

const told = (text: string) => {
  const place = at(text);
  return place && `${place.kind} ${place.path.join('.')}`;
};

describe('a place in a text', () => {
  it.each([
    ['|', 'key '],
    ['rob|', 'key '],
    ['rsal: 1\n|', 'key '],
    ['rsal: |', 'value rsal'],
    ['run:\n  |', 'key run'],
    ['run:\n  se|', 'key run'],
    ['run:\n  seed: 4|', 'value run.seed'],
    ['run:\n  seed: 4\n|', 'key '],
    ['run:\n  clock:\n    mode: |\n  stop: []', 'value run.clock.mode'],
    ['run:\n  clock:\n    mode: wall\n  |', 'key run'],
    ['run:\n\n\n    |', 'key run'],
    ['run:\n  # why\n\n  |', 'key run'],
    ['run:\n# why\n  se|', 'key run'],
    ['faults:\n  - kind: dead\n  - |', 'key faults.1'],
    ['faults:\n  - kind: dead\n    |', 'key faults.0'],
    ['faults:\n- kind: dead\n- ki|', 'key faults.1'],
    ['faults:\n- kind: dead\nrun:\n  |', 'key run'],
    ['a:\n  - - x\n    - |', 'key a.0.1'],
    ['world: {|', 'key world'],
    ['world: { ma|', 'key world'],
    ['world: {map: |', 'value world.map'],
    ['world: {map: off|', 'value world.map'],
    ['world: {map: office, |', 'key world'],
    ['world: {map: office}\n|', 'key '],
    ['robots:\n  one: {model: a, devices: {laser: {type: |', 'value robots.one.devices.laser.type'],
    ['stop:\n  - {when: time > 3, outcome: |', 'value stop.0.outcome'],
    ['a: [1, 2, |', 'value a.2'],
    ['a: [{b: 1}, {|', 'key a.1'],
    ['a:\n  {\n    b: 1,\n    |', 'key a'],
    ['a:\n  {\n    b: {c: 1},\n    d: |', 'value a.d'],
    ['a: {b: 1}\nc:\n  d: "x: {"\n  |', 'key c'],
    ['"a b":\n  |', 'key a b'],
    ['run:\r\n  |', 'key run'],
  ])('%j', (text, expected) => expect(told(text)).toBe(expected));

  it('is none in a comment, and none in a text of several lines', () => {
    expect(at('run: 1 # se|')).toBeNull();
    expect(at('# |')).toBeNull();
    expect(at('a: {b: 1 # |')).toBeNull();
    expect(at('title: >-\n  some |\n')).toBeNull();
    expect(told('title: >-\n  some\n\n  more\nworld: |')).toBe('value world');
  });

  it('says where the word begins, and whether it is in brackets', () => {
    expect(at('run:\n  se|')).toMatchObject({ from: 7, inBrackets: false });
    expect(at('run: {se|')).toMatchObject({ from: 6, inBrackets: true });
    expect(at('run: {seed:  12|')).toMatchObject({ from: 13, inBrackets: true });
    expect(at('run:\n  clock: wa|')).toMatchObject({ from: 14 });
  });

  it('is found wherever a text is cut off', () => {
    const text = 'a:\n  - {b: [1, "x"], c: {d: e}} # f\n  - g: |\n      h\n"i": \'j\'\n...\n]}{[:,-';
    for (let end = 0; end <= text.length; end++) {
      expect(() => placeAt(text, end)).not.toThrow();
    }
  });
});

describe('what is written', () => {
  it('is known by path, with its words', () => {
    const text = 'world: {map: office} # here\nrobots:\n  a: {count: 2}\n  "b":\n    model: x # y\n';
    expect(entriesOf(text).map(({ path, value }) => `${path.join('.')}=${value}`)).toEqual([
      'world=',
      'world.map=office',
      'robots=',
      'robots.a=',
      'robots.a.count=2',
      'robots.b=',
      'robots.b.model=x',
    ]);
  });

  it('is found where its key stands', () => {
    const text = 'run:\n  seed: 4\n';
    expect(entryAt(text, 8)?.path).toEqual(['run', 'seed']);
    expect(entryAt(text, 13)).toBeNull();
  });
});
