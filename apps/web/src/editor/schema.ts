import { entriesOf, inside, placeAt, type Entry, type Step } from './yaml';

/** As much of JSON Schema as that of scenarios has. */
export interface Schema {
  description?: string;
  type?: string | string[];
  enum?: unknown[];
  const?: unknown;
  default?: unknown;
  minimum?: number;
  maximum?: number;
  properties?: Record<string, Schema>;
  additionalProperties?: Schema | boolean;
  required?: string[];
  items?: Schema;
  anyOf?: Schema[];
  oneOf?: Schema[];
  allOf?: Schema[];
  $ref?: string;
  $defs?: Record<string, Schema>;
}

/** What may be written. */
export interface Offer {
  label: string;
  kind: 'key' | 'value';
  /** Range and default, in a few words. */
  detail: string;
  description: string;
  required: boolean;
}

/** Where names are declared that other places refer to, by the key that refers. */
const DECLARED: Record<string, string> = { robot: 'robots' };
const CONFIGURATIONS = 'configurations';
const ARGUMENT = '#/$defs/argument';

/** What may be written at a place, and where the word begins that it would replace. */
export function offersAt(
  schema: Schema,
  text: string,
  offset: number,
): { from: number; offers: Offer[] } | null {
  const place = placeAt(text, offset);
  if (!place) {
    return null;
  }
  const entries = entriesOf(text);
  const schemas = schemasAt(schema, place.path, entries);
  const offers: Offer[] = [];
  if (place.kind === 'key') {
    const used = inside(entries, place.path)
      .filter(({ from }) => from !== place.from)
      .map(({ path }) => path.at(-1));
    const all = [...keys(schema, schemas), ...overlaid(place.path, entries)];
    offers.push(...all.filter(({ label }) => !used.includes(label)));
  }
  if (place.kind === 'value' || typeof place.path.at(-1) === 'number') {
    offers.push(...values(schemas), ...declared(schemas, place.path, entries));
  }
  return { from: place.from, offers: unique(offers) };
}

/** What a key means; empty when nobody knows. */
export function describe(
  schema: Schema,
  entry: Entry,
  entries: readonly Entry[],
): { text: string; detail: string } {
  const schemas = schemasAt(schema, entry.path, entries);
  return {
    text: schemas.find(({ description }) => description)?.description ?? '',
    detail: detailOf(schemas),
  };
}

/** All that may hold at a path, with the alternatives that what is written there has chosen. */
function schemasAt(root: Schema, path: readonly Step[], entries: readonly Entry[]): Schema[] {
  let found = chosen(root, [root], [], entries);
  path.forEach((step, i) => {
    const next = found.flatMap((schema) =>
      typeof step === 'number' ? (schema.items ?? []) : child(schema, step),
    );
    found = chosen(root, next, path.slice(0, i + 1), entries);
  });
  return found;
}

function child({ properties, additionalProperties }: Schema, key: string): Schema[] {
  const own = properties && Object.hasOwn(properties, key) ? properties[key] : undefined;
  return own ? [own] : typeof additionalProperties === 'object' ? [additionalProperties] : [];
}

/** Takes alternatives apart, and leaves out those that have another type, kind or use than what is written there. */
function chosen(root: Schema, schemas: Schema[], path: readonly Step[], entries: readonly Entry[]): Schema[] {
  const present = new Map(inside(entries, path).map((entry) => [entry.path.at(-1), entry.value]));
  const fits = (schema: Schema) =>
    apart(root, schema).every(({ properties = {} }) =>
      Object.entries(properties).every(
        ([key, { const: only }]) =>
          only === undefined || !present.get(key) || present.get(key) === String(only),
      ),
    );
  const alternatives = (schema: Schema): Schema[] => {
    const resolved = resolve(root, schema);
    const choices = [...(resolved.anyOf ?? []), ...(resolved.oneOf ?? [])].filter(fits);
    return [resolved, ...[...choices, ...(resolved.allOf ?? [])].flatMap(alternatives)];
  };
  return schemas.flatMap(alternatives);
}

/** A schema with all that must hold beside it. */
function apart(root: Schema, schema: Schema): Schema[] {
  const resolved = resolve(root, schema);
  return [resolved, ...(resolved.allOf ?? []).flatMap((part) => apart(root, part))];
}

function resolve(root: Schema, schema: Schema): Schema {
  const name = schema.$ref?.replace('#/$defs/', '');
  return name === undefined || schema.$ref === ARGUMENT ? schema : (root.$defs?.[name] ?? {});
}

function keys(root: Schema, schemas: readonly Schema[]): Offer[] {
  return schemas.flatMap(({ properties = {}, required = [] }) =>
    Object.entries(properties).map(([label, schema]) => {
      const all = chosen(root, [schema], [], []);
      return {
        label,
        kind: 'key' as const,
        detail: detailOf(all),
        description: all.find(({ description }) => description)?.description ?? '',
        required: required.includes(label),
      };
    }),
  );
}

function values(schemas: readonly Schema[]): Offer[] {
  return schemas.flatMap((schema) => {
    const all = [...(schema.enum ?? []), schema.const, schema.default].filter(isWord);
    if (schema.type === 'boolean') {
      all.push('true', 'false');
    }
    return all.map((value) => written(String(value), schema.description ?? ''));
  });
}

const isWord = (value: unknown): value is string | number | boolean =>
  ['string', 'number', 'boolean'].includes(typeof value) && value !== '';

/** What a configuration may say anew: the names of roles, agents, devices and whatever else is there without it. */
function overlaid(path: readonly Step[], entries: readonly Entry[]): Offer[] {
  const [group, , ...below] = path;
  if (group !== CONFIGURATIONS || below.length === 0) {
    return [];
  }
  return inside(entries, below)
    .map(({ path }) => path.at(-1))
    .filter((name) => typeof name === 'string')
    .map((name) => ({ ...written(name, ''), kind: 'key' }));
}

/** Names that are declared elsewhere: arguments, wherever they may stand for a value, and roles of robots. */
function declared(schemas: readonly Schema[], path: readonly Step[], entries: readonly Entry[]): Offer[] {
  const names = (group: string) => inside(entries, [group]).map(({ path }) => String(path.at(-1)));
  const group = DECLARED[String(path.at(-1))];
  return [
    ...(group ? names(group) : []),
    ...(schemas.some(({ $ref }) => $ref === ARGUMENT) ? names('arguments').map((name) => `$${name}`) : []),
  ].map((name) => written(name, ''));
}

const written = (label: string, description: string): Offer => ({
  label,
  kind: 'value',
  detail: '',
  description,
  required: false,
});

function detailOf(schemas: readonly Schema[]): string {
  const range = schemas.find(({ minimum, maximum }) => minimum !== undefined || maximum !== undefined);
  const usual = schemas.find((schema) => isWord(schema.default))?.default;
  const words = [
    range ? `${String(range.minimum ?? '')}…${String(range.maximum ?? '')}` : '',
    usual === undefined ? '' : `= ${String(usual as string)}`,
  ];
  return words.filter((word) => word !== '').join(' ');
}

function unique(offers: readonly Offer[]): Offer[] {
  const known = new Map<string, Offer>();
  for (const offer of offers) {
    if (!known.has(offer.label)) {
      known.set(offer.label, offer);
    }
  }
  return [...known.values()];
}
