import { access } from '../api/access.svelte';
import { api, askAbout } from '../api/client';
import type {
  CarriedInfo,
  Details,
  EventInfo,
  Reach,
  RealDetails,
  RobotDetails,
  RobotInfo,
  RunInfo,
  ServerMessage,
} from '../api/messages';
import { connect, type Listener } from './connection';
import { merged } from './details';
import { brief } from '../format';
import { withShades } from '../shades';
import { marksAmong } from '../timeline/marks';
import { decodeFrame, type Frame } from './frame';
import { Things } from './things';

const MOST_EVENTS = 5000;
/** A recording is there as a whole, and so are its events. */
const MOST_RECORDED_EVENTS = 110_000;
const MOST_MARKED = 5000;
/** How often the panels follow the frames; the map follows each one. */
const PANEL_MILLIS = 200;

/** The run, as the server last told it. Nothing here is guessed: a click changes it only by way of the server. */
class Live implements Listener {
  /** Open once the server has told which run it shows: until then, what was shown may be another one's. */
  connection = $state<'connecting' | 'open' | 'gone' | 'closed'>('connecting');
  info = $state.raw<RunInfo | null>(null);
  /** Counts runs that this page was told of. One that it comes back to, as its connection was lost, is the same. */
  told = $state(0);
  details = $state.raw<Details | null>(null);
  /** What of the simulated world is not a robot. */
  things = $state.raw(Things.NONE);
  /** Oldest first. */
  events = $state.raw<EventInfo[]>([]);
  /** Those that are marked on the timeline. */
  marked = $state.raw<EventInfo[]>([]);
  /** How far one can look back. */
  reach = $state.raw<Reach | null>(null);
  /** The newest frame, for panels: a few times a second. */
  frame = $state.raw<Frame | null>(null);

  /** The newest two frames with the time they came [ms of performance.now()], for the map. */
  newest: { frame: Frame; at: number } | null = null;
  previous: { frame: Frame; at: number } | null = null;

  /** Called with what happens while this page looks on, not with what happened before. */
  onNews: (event: EventInfo) => void = () => {};
  /** Called before another run is shown. */
  onOther: () => void = () => {};

  private readonly drawers = new Set<() => void>();
  private robots: RobotInfo[] = []; // in the colors of their roles
  private joined = Infinity; // simulated seconds
  private panelsFollowed = 0;
  private catchUp: number | undefined;

  start() {
    connect(this);
  }

  onGone(closed: boolean) {
    this.connection = closed ? 'closed' : 'gone';
  }

  /** Of the robot of that index; null when there is none. */
  idOf(robot: number | null): string | null {
    return robot === null ? null : (this.info?.robots[robot]?.id ?? null);
  }

  /** What is told of the run that is shown, once more: what came of its scenario's file may have changed. */
  async readRun() {
    const run = await api.run();
    if (run && this.info && run.number === this.info.number) {
      this.info = { ...this.info, edited: run.edited };
    }
  }

  onMessage(message: ServerMessage) {
    if (message.run) {
      if (!isSame(message.run, this.info)) {
        askAbout(message.run.number);
        this.onOther();
        this.told++;
      }
      this.connection = 'open';
      access.past = false; // until a frame says otherwise
      this.robots = message.run.robots;
      this.info = { ...message.run, robots: withShades(this.robots) };
      this.things = Things.NONE;
      this.details = null;
      this.events = [];
      this.marked = [];
      this.reach = null;
      this.frame = null;
      this.newest = null;
      this.previous = null;
      this.joined = Infinity;
    } else if (message.newcomers) {
      this.robots = this.robots.concat(message.newcomers.robots);
      this.info = { ...this.info!, robots: withShades(this.robots) };
    } else if (message.things) {
      this.things = this.things.after(message.things);
    } else if (message.details) {
      this.details = merged(this.details, message.details);
    } else if (message.events) {
      const events = message.events.events.map((event) => ({ ...event, text: brief(event.text) }));
      const most = this.recording ? MOST_RECORDED_EVENTS : MOST_EVENTS;
      this.events = this.events.concat(events).slice(-most);
      this.marked = this.marked.concat(marksAmong(events)).slice(-MOST_MARKED);
      if (this.recording) {
        return;
      }
      events.filter(({ time }) => time > this.joined).forEach((event) => this.onNews(event));
    } else if (message.reach) {
      this.reach = message.reach;
    }
  }

  onFrame(bytes: ArrayBuffer) {
    const frame = decodeFrame(bytes);
    this.joined = Math.min(this.joined, frame.time);
    access.past = frame.past;
    this.previous = this.newest;
    this.newest = { frame, at: performance.now() };
    this.drawers.forEach((told) => told());
    this.tellPanels();
  }

  /** Tells of each frame, until what it returns is called. */
  onEachFrame(told: () => void): () => void {
    this.drawers.add(told);
    return () => this.drawers.delete(told);
  }

  private tellPanels() {
    const wait = this.panelsFollowed + PANEL_MILLIS - performance.now();
    clearTimeout(this.catchUp);
    if (wait <= 0 || this.frame === null || switched(this.frame, this.newest?.frame)) {
      this.panelsFollowed = performance.now();
      this.frame = this.newest?.frame ?? null;
    } else {
      this.catchUp = window.setTimeout(() => this.tellPanels(), wait);
    }
  }

  /** What the server has said of robots, by index; of those that are there. */
  readonly said: ReadonlyMap<number, RobotDetails> = $derived.by(() => {
    const details = new Map(this.details?.robots.map((robot) => [robot.id, robot]));
    return new Map(
      (this.info?.robots ?? []).flatMap(({ id }, i) => {
        const own = details.get(id);
        return own ? [[i, own]] : [];
      }),
    );
  });

  /** Indices of the robots that are there. */
  readonly present: readonly number[] = $derived(
    this.details === null ? (this.info?.robots ?? []).map((_, i) => i) : [...this.said.keys()],
  );

  /**
   * Indices of those that nobody hears of: a fault has taken them away, or they are real and silent. Some of them stand
   * where they were.
   */
  readonly faded: ReadonlySet<number> = $derived(
    new Set(
      [...this.said].flatMap(([i, { gone, real }]) => (gone || typeof real?.silence === 'number' ? [i] : [])),
    ),
  );

  /** What there is to say of those that are real, by index. */
  readonly real: ReadonlyMap<number, RealDetails> = $derived(
    new Map([...this.said].flatMap(([i, { real }]) => (real ? [[i, real]] : []))),
  );

  /** What actuators of robots have carried elsewhere, by index. */
  readonly carried: ReadonlyMap<number, readonly CarriedInfo[]> = $derived(
    new Map([...this.said].flatMap(([i, { carried }]) => (carried.length > 0 ? [[i, carried]] : []))),
  );

  /** Whether a robot is there: it may have been removed, and keeps its index. */
  isThere(robot: number): boolean {
    return this.details === null || this.said.has(robot);
  }

  /** Whether what is shown has been, and is not now. */
  get past(): boolean {
    return access.past;
  }

  /** Where the run is from, if it is none that goes on. */
  get recording() {
    return this.info?.recording ?? null;
  }

  /** When the moment is that is shown, to ask about what has been [s of the run]; null for the present. */
  get pastTime(): number | null {
    return this.recording || this.past ? (this.newest?.frame.time ?? 0) : null;
  }

  /** Whether it is the past of a run that goes on. */
  readonly lookingBack: boolean = $derived(this.past && !this.recording);

  private readonly happenedCount: number = $derived(
    this.past ? countUntil(this.events, this.frame?.time ?? 0) : this.events.length,
  );

  /** What had happened by the time that is shown, oldest first. Another one only when that is other. */
  readonly happened: readonly EventInfo[] = $derived(
    this.happenedCount < this.events.length ? this.events.slice(0, this.happenedCount) : this.events,
  );

  readonly over: boolean = $derived(this.frame?.ended === true || (this.details?.ending ?? null) !== null);

  /** Whether it has got anywhere yet: before that nobody knows who is there, which takes a while with a thousand. */
  readonly begun: boolean = $derived((this.frame?.time ?? 0) > 0 || this.over);

  /** Whether it goes on by itself. */
  readonly going: boolean = $derived(this.frame !== null && !this.frame.paused && !this.over);
}

/** Whether something changed that a person is waiting to see. */
function switched(a: Frame, b: Frame | undefined): boolean {
  return (
    a.past !== b?.past ||
    a.paused !== b.paused ||
    a.stopped !== b.stopped ||
    a.ended !== b.ended ||
    a.speed !== b.speed
  );
}

/** Another server counts its runs from 1 again. */
function isSame(a: RunInfo, b: RunInfo | null): boolean {
  return a.number === b?.number && a.process === b.process;
}

/** How many events were by a time. */
function countUntil(events: readonly EventInfo[], time: number): number {
  let low = 0;
  let high = events.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (events[middle]!.time <= time + 1e-9) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

export const live = new Live();
