import { access } from '../api/access.svelte';
import type { LookBack, Receipt, ServerMessage } from '../api/messages';

const RETRY_MILLIS = 1000;
/** The server's word for a run that somebody closed. */
const CLOSED = 4000;
/** A hidden tab draws nothing; it still takes a frame now and then, so that the server does not give it up. */
const LONGEST_DRAW_MILLIS = 1000;
/** For how long the first frame is waited for. */
const LONGEST_BEGINNING_MILLIS = 300;
/** For how long words wait for the frame behind them, which the server sends along with them. */
const LONGEST_BUNDLE_MILLIS = 30;

/** With what it has brought before somebody listened, and the code by which it has ended. */
interface Line {
  socket: WebSocket;
  said: (ArrayBuffer | string)[];
  closed: number | null;
}

// of public/early.js
declare global {
  var rsalOpen: () => Line;
  /** The first. */
  var rsalEarly: Line | undefined;
}

/** How events begin. */
const EVENTS = '{"events"';

export interface Listener {
  onFrame(bytes: ArrayBuffer): void;
  onMessage(message: ServerMessage): void;
  /** @param closed whether there will be no run any more where this page looks for it */
  onGone(closed: boolean): void;
}

let line: WebSocket | null = null;

/** Looks back on the run, or to the present again. Nothing happens while the server is gone. */
export function look(wish: Partial<LookBack>): void {
  if (line) {
    tell(line, { look: { live: false, time: null, step: 0, playing: false, speed: null, ...wish } });
  }
}

/** Listens to the run for as long as the page is open, and comes back by itself when the server does. */
export function connect(listener: Listener): void {
  const { socket, said, closed } = takeEarly() ?? rsalOpen();
  line = socket;
  const take = (data: ArrayBuffer | string) => {
    if (typeof data === 'string') {
      const message = JSON.parse(data) as ServerMessage;
      if (message.access?.control === false) {
        access.drop(); // another server answers at this address now: this tab may only watch
      }
      listener.onMessage(message);
      const last = message.events?.events.at(-1);
      if (last) {
        tell(socket, { events: last.sequence });
      }
    } else {
      listener.onFrame(data);
      const sequence = new DataView(data).getUint32(8, true);
      afterDrawing(() => tell(socket, { frame: sequence }));
    }
  };
  const bundles = new Bundles(take);
  const end = (code: number) => {
    bundles.pass();
    listener.onGone(code === CLOSED);
    if (code !== CLOSED) {
      setTimeout(() => connect(listener), RETRY_MILLIS);
    }
  };
  const listen = () => {
    said.splice(0).forEach((data) => bundles.take(data));
    socket.onmessage = ({ data }: MessageEvent<ArrayBuffer | string>) => bundles.take(data);
    if (closed !== null) {
      end(closed);
    }
  };
  socket.onclose = ({ code }) => end(code);
  const showToken = () => access.token && tell(socket, { token: access.token });
  if (socket.readyState === WebSocket.OPEN) {
    showToken();
  } else {
    socket.onopen = showToken;
  }
  queueMicrotask(listen); // once what listens is there
}

/** The line that was opened while this was loaded, once. */
function takeEarly(): Line | undefined {
  const early = globalThis.rsalEarly;
  globalThis.rsalEarly = undefined;
  return early;
}

/**
 * Passes on what a line brings: words together with the frame that comes behind them, for which they wait a little. So
 * the page is laid out and drawn once for all of it; at the beginning the first picture is there sooner. Events, which
 * come behind frames, and what a hidden page is told wait for nothing.
 */
export class Bundles {
  private held: (ArrayBuffer | string)[] = [];
  private timer: ReturnType<typeof setTimeout> | undefined;
  private patience = LONGEST_BEGINNING_MILLIS;

  constructor(private readonly next: (data: ArrayBuffer | string) => void) {}

  take(data: ArrayBuffer | string) {
    this.held.push(data);
    if (typeof data === 'string' && !data.startsWith(EVENTS) && !globalThis.document?.hidden) {
      this.timer ??= setTimeout(() => this.pass(), this.patience);
    } else {
      this.pass();
    }
  }

  /** Waits no longer. */
  pass() {
    clearTimeout(this.timer);
    this.timer = undefined;
    this.patience = LONGEST_BUNDLE_MILLIS;
    const held = this.held;
    this.held = [];
    for (const data of held) {
      try {
        this.next(data);
      } catch (error) {
        reportError(error); // the others are taken nevertheless, as if each came by itself
      }
    }
  }
}

function tell(socket: WebSocket, receipt: Partial<Receipt>) {
  if (socket.readyState === WebSocket.OPEN) {
    socket.send(JSON.stringify(receipt));
  }
}

/** Does something when the screen has its next picture, or soon where none is drawn. */
export function afterDrawing(action: () => void) {
  let done = false;
  const once = () => {
    if (!done) {
      done = true;
      action();
    }
  };
  requestAnimationFrame(once);
  setTimeout(once, LONGEST_DRAW_MILLIS);
}
