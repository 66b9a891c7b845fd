import { autocompletion, completionKeymap, type CompletionResult } from '@codemirror/autocomplete';
import { standardKeymap, history, historyKeymap } from '@codemirror/commands';
import { indentService, indentUnit } from '@codemirror/language';
import { EditorState, StateEffect, StateField, type Text } from '@codemirror/state';
import {
  Decoration,
  EditorView,
  highlightActiveLine,
  highlightActiveLineGutter,
  hoverTooltip,
  keymap,
  lineNumbers,
  MatchDecorator,
  ViewPlugin,
  type DecorationSet,
} from '@codemirror/view';
import type { TextError } from '../api/messages';
import { describe, offersAt, type Offer, type Schema } from './schema';
import { entriesOf, entryAt } from './yaml';

/** What a text is edited with. Loaded when it is needed, as it is as large as half of the page. */
export interface Editor {
  text(): string;
  show(errors: readonly TextError[]): void;
  goTo(error: TextError): void;
  focus(): void;
  destroy(): void;
}

export interface Wishes {
  label: string;
  changed: () => void;
  run: () => void;
  save: () => void;
}

/**
 * Puts an editor into an element. It lives in a shadow tree, as only there its styles need no inline `<style>`, which
 * the page's Content-Security-Policy forbids. Tab is left to the browser, so that keys lead out of it.
 */
export function edit(host: HTMLElement, text: string, schema: Schema, wishes: Wishes): Editor {
  const root = host.shadowRoot ?? host.attachShadow({ mode: 'open' });
  const always = (then: () => void) => () => {
    then();
    return true;
  };
  const view = new EditorView({
    root,
    parent: root,
    state: EditorState.create({
      doc: text,
      extensions: [
        // so that a file from Windows stays one
        ...(text.includes('\r\n') ? [EditorState.lineSeparator.of('\r\n')] : []),
        lineNumbers(),
        highlightActiveLine(),
        highlightActiveLineGutter(),
        history(),
        indentUnit.of('  '),
        deeper,
        colors,
        underlined,
        autocompletion({ override: [completions(schema)], icons: false }),
        meanings(schema),
        theme,
        EditorView.lineWrapping,
        EditorView.contentAttributes.of({ 'aria-label': wishes.label, tabindex: '0' }),
        EditorView.updateListener.of(({ docChanged }) => {
          if (docChanged) {
            wishes.changed();
          }
        }),
        keymap.of([
          { key: 'Mod-Enter', run: always(wishes.run) },
          { key: 'Mod-s', run: always(wishes.save), preventDefault: true },
          ...completionKeymap,
          ...historyKeymap,
          ...standardKeymap,
        ]),
      ],
    }),
  });
  return {
    text: () => view.state.sliceDoc(),
    show: (errors) => view.dispatch({ effects: found.of(errors) }),
    goTo: ({ line, column }) => {
      const anchor = offsetOf(view.state.doc, line, column);
      view.dispatch({ selection: { anchor }, scrollIntoView: true });
      view.focus();
    },
    focus: () => view.focus(),
    destroy: () => view.destroy(),
  };
}

function offsetOf(doc: Text, line: number, column: number): number {
  const { from, to } = doc.line(Math.min(Math.max(line, 1), doc.lines));
  return Math.min(from + Math.max(column - 1, 0), to);
}

/** What is wrong with the text as it is now. */
const found = StateEffect.define<readonly TextError[]>();

/** Each error's word is underlined, until the text is checked again. */
const underlined = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(marks, { changes, effects, newDoc }) {
    const news = effects.find((effect) => effect.is(found));
    return news
      ? Decoration.set(
          news.value.map((error) => mark(newDoc, error)),
          true,
        )
      : marks.map(changes);
  },
  provide: (field) => EditorView.decorations.from(field),
});

function mark(doc: Text, { line, column, message, remedy }: TextError) {
  const at = offsetOf(doc, line, column);
  const { from: start, to: end } = doc.lineAt(at);
  const word = /^(?:"[^"]*"|'[^']*'|[^\s,:[\]{}]+)/.exec(doc.sliceString(at, end))?.[0].length ?? 1;
  const to = Math.min(at + word, end);
  // what ends too early has no word there: so the whole line
  const [from, until] = at < to ? [at, to] : [start, end];
  const attributes = { 'data-error': `${message} ${remedy}`.trim() };
  return from < until
    ? Decoration.mark({ class: 'error', attributes }).range(from, until)
    : Decoration.line({ class: 'invalid', attributes }).range(start);
}

const completions =
  (schema: Schema) =>
  ({
    state,
    pos,
    explicit,
  }: {
    state: EditorState;
    pos: number;
    explicit: boolean;
  }): CompletionResult | null => {
    const found = offersAt(schema, state.doc.toString(), pos);
    if (!found || found.offers.length === 0 || (found.from === pos && !explicit)) {
      return null;
    }
    return {
      from: found.from,
      options: found.offers.map((offer) => ({
        label: offer.label,
        detail: offer.detail,
        boost: offer.required ? 1 : 0,
        apply: written(offer, state.sliceDoc(pos, pos + 1)),
        ...(offer.description && { info: offer.description }),
      })),
      validFor: /^[\w$-]*$/,
    };
  };

/** With a colon, unless one stands there. */
const written = ({ label, kind }: Offer, next: string) =>
  kind === 'value' || next === ':' ? label : `${label}: `;

const meanings = (schema: Schema) =>
  hoverTooltip((view, pos) => {
    const wrong = errorAt(view.state, pos);
    if (wrong) {
      return tooltip(wrong.from, wrong.to, wrong.text);
    }
    const text = view.state.doc.toString();
    const entry = entryAt(text, pos);
    const meaning = entry && describe(schema, entry, entriesOf(text));
    return entry && meaning?.text
      ? tooltip(entry.from, entry.to, `${meaning.text} ${meaning.detail}`.trim())
      : null;
  });

function errorAt(state: EditorState, pos: number): { from: number; to: number; text: string } | null {
  let told = null;
  state.field(underlined).between(pos, pos, (from, to, { spec }: { spec: Spec }) => {
    told = { from, to, text: spec.attributes['data-error'] };
    return false;
  });
  return told;
}

interface Spec {
  attributes: { 'data-error': string };
}

function tooltip(pos: number, end: number, text: string) {
  const dom = document.createElement('div');
  dom.className = 'meaning';
  dom.textContent = text;
  return { pos, end, create: () => ({ dom }) };
}

/** Below a key or the begin of a bracket, lines are further in; else they are as the one before. */
const deeper = indentService.of((context, pos) => {
  const before = context.lineAt(pos, -1);
  const indent = before.text.search(/\S|$/);
  return /[:{[]\s*$/.test(before.text) ? indent + context.unit : indent;
});

/** Line by line, which is enough to read a text by. */
const words = new MatchDecorator({
  regexp:
    /(?<comment>(?:^|(?<=\s))#.*)|(?<key>"[^"]*"(?=\s*:(?:\s|$))|[\w-]+(?=\s*:(?:\s|$)))|(?<string>"[^"]*"|'[^']*')|(?<argument>\$[\w-]+)/g,
  decoration: ({ groups = {} }) =>
    Decoration.mark({ class: Object.keys(groups).find((name) => groups[name]) ?? '' }),
});

const colors = ViewPlugin.define(
  (view) => {
    const plugin = {
      marks: words.createDeco(view),
      update: (update: Parameters<typeof words.updateDeco>[0]) => {
        plugin.marks = words.updateDeco(update, plugin.marks);
      },
    };
    return plugin;
  },
  { decorations: ({ marks }) => marks },
);

const theme = EditorView.theme({
  '&': { height: '100%', color: 'var(--text)', backgroundColor: 'var(--surface)', fontSize: '13px' },
  '&.cm-focused': { outline: 'none' },
  '.cm-scroller': {
    fontFamily: 'ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace',
    lineHeight: '1.5',
  },
  '.cm-content': { caretColor: 'var(--text)' },
  '.cm-gutters': {
    color: 'var(--muted)',
    backgroundColor: 'var(--surface)',
    borderRight: '1px solid var(--line)',
  },
  '.cm-activeLine, .cm-activeLineGutter': {
    backgroundColor: 'color-mix(in srgb, var(--accent) 7%, transparent)',
  },
  '.cm-tooltip': {
    maxWidth: '420px',
    border: '1px solid var(--line-strong)',
    borderRadius: '7px',
    color: 'var(--text)',
    backgroundColor: 'var(--surface)',
    boxShadow: 'var(--shadow)',
    fontFamily: 'system-ui, sans-serif',
    overflow: 'hidden',
  },
  '.cm-tooltip.cm-tooltip-autocomplete': { overflow: 'visible' },
  '.cm-tooltip.cm-tooltip-autocomplete > ul > li': { padding: '3px 8px' },
  '.cm-tooltip.cm-tooltip-autocomplete > ul > li[aria-selected]': {
    color: 'var(--on-accent)',
    backgroundColor: 'var(--accent)',
  },
  '.cm-completionDetail': { opacity: '0.8' },
  '.cm-completionMatchedText': { textDecoration: 'none', fontWeight: '600' },
  '.meaning': { padding: '6px 10px' },
  '.comment': { color: 'var(--muted)', fontStyle: 'italic' },
  '.key': { color: 'var(--accent)' },
  '.string': { color: 'var(--good)' },
  '.argument': { color: 'var(--warn)' },
  '.error': { textDecoration: 'underline wavy var(--bad)', textUnderlineOffset: '3px' },
  '.invalid': { borderLeft: '3px solid var(--bad)' },
});
