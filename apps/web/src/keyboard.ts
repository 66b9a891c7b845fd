/** What keys do, unless something that takes text has the focus. */
export type Action =
  | {
      kind:
        | 'emergencyStop'
        | 'pause'
        | 'step'
        | 'faster'
        | 'slower'
        | 'stepBack'
        | 'eventBefore'
        | 'eventAfter'
        | 'present'
        | 'goal'
        | 'follow'
        | 'onboard'
        | 'measure'
        | 'drive'
        | 'fit'
        | 'upright'
        | 'mapAlone'
        | 'oblique'
        | 'menu'
        | 'scenarios'
        | 'sweep'
        | 'beside'
        | 'restart'
        | 'help'
        | 'cancel';
    }
  | { kind: 'select'; robot: number }
  | { kind: 'zoom'; factor: number }
  | { kind: 'turn'; by: number }
  | { kind: 'pan'; dx: number; dy: number };

const ZOOM = 1.25;
const PAN = 60;
const TURN = Math.PI / 12;

/** Types nothing, and no browser wants it: so it can work in fields and dialogs, too, and is not hit while writing. */
const EMERGENCY_STOP = 'F8';

const actions: Record<string, Action> = {
  [EMERGENCY_STOP]: { kind: 'emergencyStop' },
  ' ': { kind: 'emergencyStop' },
  p: { kind: 'pause' },
  '.': { kind: 'step' },
  ',': { kind: 'stepBack' },
  '[': { kind: 'eventBefore' },
  ']': { kind: 'eventAfter' },
  l: { kind: 'present' },
  '+': { kind: 'faster' },
  '=': { kind: 'faster' }, // the same key without shift
  '-': { kind: 'slower' },
  g: { kind: 'goal' },
  f: { kind: 'follow' },
  e: { kind: 'onboard' },
  t: { kind: 'measure' },
  k: { kind: 'drive' },
  '0': { kind: 'fit' },
  h: { kind: 'mapAlone' },
  n: { kind: 'upright' },
  v: { kind: 'oblique' },
  i: { kind: 'zoom', factor: ZOOM },
  o: { kind: 'zoom', factor: 1 / ZOOM },
  m: { kind: 'menu' },
  c: { kind: 'scenarios' },
  x: { kind: 'sweep' },
  b: { kind: 'beside' },
  r: { kind: 'restart' },
  '?': { kind: 'help' },
  Escape: { kind: 'cancel' },
  ArrowLeft: { kind: 'pan', dx: PAN, dy: 0 },
  ArrowRight: { kind: 'pan', dx: -PAN, dy: 0 },
  ArrowUp: { kind: 'pan', dx: 0, dy: PAN },
  ArrowDown: { kind: 'pan', dx: 0, dy: -PAN },
};

const withShift: Record<string, Action> = {
  ArrowLeft: { kind: 'turn', by: TURN },
  ArrowRight: { kind: 'turn', by: -TURN },
};

type Pressed = Pick<KeyboardEvent, 'key' | 'shiftKey' | 'ctrlKey' | 'metaKey' | 'altKey' | 'target'>;

export function actionOf(event: Pressed): Action | null {
  if (!isOurs(event)) {
    return null;
  }
  if (event.key >= '1' && event.key <= '9' && event.key.length === 1) {
    return { kind: 'select', robot: Number(event.key) - 1 };
  }
  if (event.shiftKey && withShift[event.key]) {
    return withShift[event.key]!;
  }
  return actions[event.key.length === 1 ? event.key.toLowerCase() : event.key] ?? null;
}

/** Whether a key means something to the page, and not to the browser or to what has the focus. */
export function isOurs(event: Pressed): boolean {
  return !(isModified(event) || takesKeys(event.target, event.key));
}

/** Whether what is pressed belongs to the browser or the system. On macOS nobody hears of keys released meanwhile. */
export function isModified(event: Pick<Pressed, 'ctrlKey' | 'metaKey' | 'altKey'>): boolean {
  return event.ctrlKey || event.metaKey || event.altKey;
}

/** Whether somebody writes there: Esc leaves it, or empties it, and nothing else. */
export function isWritten(target: EventTarget | null): target is HTMLInputElement | HTMLTextAreaElement {
  const { tagName, type } = (target ?? {}) as Partial<Focused>;
  return tagName === 'TEXTAREA' || (tagName === 'INPUT' && type !== 'range' && type !== 'checkbox');
}

interface Focused {
  tagName: string;
  type: string;
  shadowRoot: object | null;
  dataset: { pointed?: string };
  closest: (selector: string) => object | null;
}

/** Whether the focused element needs the key itself. */
function takesKeys(target: EventTarget | null, key: string): boolean {
  const element = target as Partial<Focused> | null;
  const isClosed = element?.closest?.('dialog:not([open])'); // which a browser lets go of only a moment later
  if (key === 'Escape' || key === EMERGENCY_STOP || isClosed) {
    return false;
  }
  switch (element?.tagName) {
    case 'TEXTAREA':
      return true;
    case 'SELECT':
      return !(key === ' ' && element.dataset?.pointed); // see controls/focus
    case 'BUTTON':
    case 'SUMMARY':
      return key === ' ';
    case 'INPUT':
      return element.type === 'range'
        ? key.startsWith('Arrow')
        : element.type === 'checkbox'
          ? key === ' '
          : true;
    default:
      return Boolean(element?.shadowRoot); // the editor of texts
  }
}
