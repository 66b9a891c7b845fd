/**
 * Where one is in a YAML text, however little of it is written: by indentation and brackets, as what is half written
 * has no syntax tree that could be trusted. Knows what scenarios are written with, not all of YAML.
 */

/** A key, or the index of a list's item. */
export type Step = string | number;

/** A key that is written. */
export interface Entry {
  /** With the key itself. */
  path: Step[];
  /** Of the key, in the text. */
  from: number;
  to: number;
  /** What is written behind it on the line, when that is a word. */
  value: string;
}

/** What could be written at a place: a key of the group `path`, or its value. */
export interface Place {
  kind: 'key' | 'value';
  path: Step[];
  /** Where the word begins that is being written. */
  from: number;
  /** Whether brackets are around it. */
  inBrackets: boolean;
}

interface Level {
  /** Columns; what is in it has more. */
  indent: number;
  step: Step;
}

interface Bracket {
  list: boolean;
  /** The key whose value is being written. */
  key: string | null;
  index: number;
}

const KEY = /^("(?:[^"\\]|\\.)*"|'(?:[^']|'')*'|[^\s#[\]{},&*!|>'"%@`-][^#[\]{},]*?)\s*:(?=\s|$)/;
const WORD = /^[^\s#[\]{},][^#[\]{},]*/;

/** All keys, in the order in which they are written. */
export function entriesOf(text: string): Entry[] {
  return new Reader(text).read().entries;
}

/** Where a person writes; null in a comment, or in a text of several lines. */
export function placeAt(text: string, offset: number): Place | null {
  return new Reader(text.slice(0, offset)).read().place;
}

/** The key that is written there. */
export function entryAt(text: string, offset: number): Entry | null {
  return entriesOf(text).find(({ from, to }) => from <= offset && offset <= to) ?? null;
}

/** Whether two paths are the same. */
export function same(a: readonly Step[], b: readonly Step[]): boolean {
  return a.length === b.length && a.every((step, i) => step === b[i]);
}

/** What is written directly in the group at a path. */
export function inside(entries: readonly Entry[], path: readonly Step[]): Entry[] {
  return entries.filter((entry) => same(entry.path.slice(0, -1), path));
}

class Reader {
  readonly entries: Entry[] = [];
  /** Where the text ends. */
  place: Place | null = null;
  private readonly levels: Level[] = [];
  private readonly brackets: Bracket[] = [];
  /** Of a text of several lines that goes on as long as lines are further in. */
  private block: number | null = null;
  private at = 0;

  constructor(private readonly text: string) {}

  read(): this {
    for (;;) {
      const end = this.text.indexOf('\n', this.at);
      const line = this.text.slice(this.at, end < 0 ? undefined : end).replace(/\r$/, '');
      this.place = null;
      this.line(line, end < 0);
      if (end < 0) {
        return this;
      }
      this.at = end + 1;
    }
  }

  private line(line: string, last: boolean): void {
    const indent = line.length - line.trimStart().length;
    if (this.block !== null && (indent > this.block || line.trim() === '')) {
      return;
    }
    this.block = null;
    if (this.brackets.length > 0) {
      this.inBrackets(line, 0);
    } else if (line.trim() === '') {
      if (last) {
        this.leave(indent, false); // elsewhere an empty line says nothing
        this.here('key', indent);
      }
    } else if (!/^\s*(#|---|\.\.\.)/.test(line)) {
      this.item(line, indent);
    }
  }

  /** What begins at a column: an item of a list, a key with its value, or a word. */
  private item(line: string, column: number): void {
    const dash = /^-(\s+|$)/.exec(line.slice(column));
    if (dash) {
      const before = this.leave(column, true);
      this.levels.push({ indent: column, step: before === null ? 0 : before + 1 });
      const next = column + dash[0].length;
      if (next < line.length) {
        this.item(line, next);
      } else {
        this.here('key', next);
      }
      return;
    }
    this.leave(column, false);
    const key = KEY.exec(line.slice(column));
    if (key) {
      const name = unquoted(key[1]!);
      this.enter(name, column, key[1]!.length);
      this.levels.push({ indent: column, step: name });
      this.value(line, column + key[0].length, column);
    } else if ('[{'.includes(line[column]!)) {
      this.inBrackets(line, column);
    } else if (!/\s#/.test(line)) {
      this.here('key', column);
    }
  }

  private value(line: string, column: number, indent: number): void {
    const start = column + (/^\s*/.exec(line.slice(column))?.[0].length ?? 0);
    const rest = line.slice(start);
    if (/^[|>][-+0-9]*\s*(#.*)?$/.test(rest)) {
      this.block = indent;
    } else if (rest.startsWith('{') || rest.startsWith('[')) {
      this.inBrackets(line, start);
    } else if (!/(^|\s)#/.test(rest)) {
      this.told(rest);
      if (start > column) {
        this.here('value', start);
      }
    } else {
      this.told(rest.replace(/(^|\s+)#.*/, ''));
    }
  }

  private inBrackets(line: string, column: number): void {
    let word = -1;
    let i = column;
    for (; i < line.length; i++) {
      const c = line[i]!;
      const top = this.brackets.at(-1);
      if (c === '{' || c === '[') {
        this.brackets.push({ list: c === '[', key: null, index: 0 });
        word = -1;
      } else if (c === '}' || c === ']') {
        this.brackets.pop();
        word = -1;
        if (this.brackets.length === 0) {
          return; // what is behind them is a comment, or an error
        }
      } else if (c === ',') {
        top!.key = null;
        top!.index++;
        word = -1;
      } else if (c === '#' && (i === 0 || line[i - 1] === ' ')) {
        return;
      } else if (c === '"' || c === "'") {
        const end = line.indexOf(c, i + 1);
        word = word < 0 ? i : word;
        if (end < 0) {
          break;
        }
        i = end;
      } else if (
        c === ':' &&
        word >= 0 &&
        !top!.list &&
        top!.key === null &&
        /^(\s|$)/.test(line.slice(i + 1))
      ) {
        const written = line.slice(word, i).trimEnd();
        const name = unquoted(written);
        this.enter(name, word, written.length);
        top!.key = name;
        word = -1;
        this.told(WORD.exec(line.slice(i + 1).trimStart())?.[0] ?? '');
      } else if (c !== ' ' && word < 0) {
        word = i;
      }
    }
    const top = this.brackets.at(-1)!;
    this.here(top.list || top.key !== null ? 'value' : 'key', word < 0 ? line.length : word);
  }

  /** Leaves what lines at a column are no longer in. Returns the index of the item before, when that is in a list. */
  private leave(column: number, forItem: boolean): number | null {
    let index: number | null = null;
    while (this.levels.length > 0 && this.levels.at(-1)!.indent >= column) {
      const { indent, step } = this.levels.at(-1)!;
      if (forItem && indent === column && typeof step === 'string') {
        break; // lists may stand right below their key
      }
      index = indent === column && typeof step === 'number' ? step : null;
      this.levels.pop();
      if (forItem && index !== null) {
        break;
      }
    }
    return index;
  }

  private enter(name: string, column: number, length: number): void {
    const from = this.at + column;
    this.entries.push({ path: [...this.path(), name], from, to: from + length, value: '' });
  }

  private told(value: string): void {
    this.entries.at(-1)!.value = unquoted(value.trim());
  }

  private here(kind: Place['kind'], column: number): void {
    this.place = { kind, path: this.path(), from: this.at + column, inBrackets: this.brackets.length > 0 };
  }

  private path(): Step[] {
    const path = this.levels.map(({ step }) => step);
    for (const { list, key, index } of this.brackets) {
      if (list) {
        path.push(index);
      } else if (key !== null) {
        path.push(key);
      }
    }
    return path;
  }
}

function unquoted(word: string): string {
  return /^(".*"|'.*')$/.test(word) ? word.slice(1, -1) : word;
}
