import { readFileSync } from 'node:fs';
import { describe as group, expect, it } from 'vitest';
import { describe, offersAt, type Schema } from './schema';
import { entriesOf, entryAt } from './yaml';

const schema = JSON.parse(
  readFileSync(new URL('../../../../docs/reference/scenario.schema.json', import.meta.url), 'utf8'),
) as Schema;

/** What is offered at the `|` in a text. */
function offered(text: string) {
  const offset = text.indexOf('|');
  return offersAt(schema, text.replace('|', ''), offset)?.offers ?? [];
}

const labels = (text: string) => offered(text).map(({ label }) => label);

group('what is offered', () => {
  it('are keys that are not yet there', () => {
    expect(labels('|')).toEqual(expect.arrayContaining(['rsal', 'world', 'robots', 'run']));
    expect(labels('rsal: 1\n|\nworld: {map: office}')).not.toContain('rsal');
    expect(labels('rsal: 1\n|\nworld: {map: office}')).not.toContain('world');
    expect(labels('run:\n  |\n  seed: 4')).toEqual(expect.arrayContaining(['clock', 'stop']));
    expect(labels('run:\n  |\n  seed: 4')).not.toContain('seed');
    expect(labels('robots:\n  one: {mo|')).toContain('model');
    expect(labels('robots:\n  one:\n    pose: {free: true, |')).toEqual(
      expect.arrayContaining(['clearance', 'within']),
    );
    expect(labels('configurations:\n  more:\n    run:\n      |')).toContain('seed');
  });

  it('are those of the type that is written', () => {
    const dead = labels('faults:\n  - kind: dead\n    |');
    expect(dead).toContain('robots');
    expect(dead).not.toContain('kind');
    const localizer = labels('robots: {one: {devices: {localizer: {type: amcl, |');
    expect(localizer).toContain('maxParticles');
    expect(labels('robots: {one: {devices: {localizer: {type: odometry, |')).not.toContain('maxParticles');
  });

  it('are values: enumerated, usual, yes or no, arguments, roles', () => {
    expect(labels('world: {map: |')).toEqual(expect.arrayContaining(['office', 'cave']));
    expect(labels('robots: {one: {devices: {laser: |')).toEqual(
      expect.arrayContaining(['urg04lx', 'utm30lx', 'front8', 'amcl']),
    );
    expect(labels('configurations: {more: {robots: {one: {devices: {laser: |')).toContain('utm30lx');
    expect(labels('run: {clock: {mode: |')).toEqual(['simulated', 'wall']);
    expect(labels('robots: {one: {proxy: |')).toEqual(expect.arrayContaining(['true', 'false']));
    expect(labels('arguments: {many: {type: integer, default: 1}}\nrobots: {one: {count: |')).toContain(
      '$many',
    );
    expect(labels('robots: {hunter: {}}\nagents:\n  a: {type: nav, robot: |')).toContain('hunter');
    expect(labels('faults: [{kind: |')).toEqual(expect.arrayContaining(['dead', 'frozen']));
  });

  it('are names of what a configuration lays over', () => {
    const text =
      'arguments: {many: {type: integer, default: 1}}\nrobots:\n  prey: {devices: {laser: urg04lx}}\n  hunter: {}\nagents: {escape: {type: nav, robot: prey}}\nconfigurations:\n  more:\n    ';
    expect(labels(`${text}robots:\n      |`)).toEqual(['prey', 'hunter']);
    expect(labels(`${text}robots:\n      prey: {}\n      |`)).toEqual(['hunter']);
    expect(labels(`${text}robots: {prey: {devices: {|`)).toContain('laser');
    expect(labels(`${text}agents: {|`)).toEqual(['escape']);
    expect(labels(`${text}arguments: {|`)).toEqual(['many']);
    expect(labels('robots: {prey: {}}\nagents: {|')).toEqual([]);
  });

  it('are described with range, default and meaning', () => {
    const count = offered('robots: {one: {|').find(({ label }) => label === 'count');
    expect(count?.detail).toBe('1…1000 = 1');
    expect(count?.description).toContain('Number of them');
    expect(
      offered('robots: {one: {pose: {free: true, |').find(({ label }) => label === 'clearance')?.description,
    ).toContain('[m]');
  });

  it('are none where nobody knows', () => {
    expect(labels('nothing:\n  |')).toEqual([]);
    expect(labels('# |')).toEqual([]);
  });
});

group('a key', () => {
  it('is described', () => {
    const text = 'run:\n  seed: 4\n';
    expect(describe(schema, entryAt(text, 8)!, entriesOf(text)).text).toContain('randomness');
    expect(describe(schema, entryAt('x: 1', 0)!, entriesOf('x: 1'))).toEqual({ text: '', detail: '' });
  });
});
