import type {
  Abilities,
  AgentInside,
  AgentTypes,
  Cameras,
  Commands,
  Control,
  ControlWish,
  Links,
  FieldError,
  Mounts,
  PastNumbers,
  Plan,
  PlottedNumbers,
  Readings,
  Refused,
  Restart,
  Routine,
  RobotModels,
  RunInfo,
  Sayables,
  ScenarioText,
  Scenarios,
  SeatInfo,
  SideBySide,
  SweepRunAgain,
  SweepRuns,
  SweepsBefore,
  SweepSize,
  SweepState,
  SweepWish,
  TextCheck,
  TextToCheck,
  TextToSave,
  Topics,
  Trails,
} from './messages';
import { texts } from '../texts';
import { access } from './access.svelte';
import { decodeGrid, type Grid } from './grid';

/** The server understood, and will not; `problems` says what is wrong with settings. */
export class RefusedError extends Error {
  constructor(
    message: string,
    readonly problems: FieldError[],
    /** Of HTTP; 0 when there was no answer. */
    readonly status = 0,
  ) {
    super(message);
  }
}

/**
 * What can be asked of the run. Addresses are relative: where several runs are side by side, the same page asks each
 * of them at its own. Each resolves when the server has done it, and rejects with a sentence for people.
 */
export const api = {
  run: () => found<RunInfo>('run'),
  /** Has the run carry out a command. */
  tell: <K extends keyof Commands>(command: K, takes: Commands[K]['takes']) =>
    post(command, takes, AT_THE_END.has(command)) as Promise<Commands[K]['answers']>,
  robotModels: () => found<RobotModels>('robots/models'),
  abilities: (robot: string) => about<Abilities>('abilities', robot),
  /** @param time of what has been [s of the run]; null for the present */
  readings: (robot: string, time: number | null = null) => about<Readings>('readings', robot, time),
  numbers: (robot: string, time: number | null = null) => about<PlottedNumbers>('numbers', robot, time),
  pastNumbers: (robot: string, device: string, number: string) =>
    ofRun<PastNumbers>('numbers/past', { robot, device, number }),
  /** @param time of what has been [s of the run]; null for the present */
  agent: (name: string, time: number | null = null) => ofRun<AgentInside>('agent', { name }, time),
  /** @param robot that is chosen, of many; empty for none
   * @param time of what has been [s of the run]; null for the present */
  links: (robot: string, time: number | null = null) => about<Links>('links', robot, time),
  sayable: () => found<Sayables>('sayable'),
  agentTypes: () => found<AgentTypes>('agents/types'),
  /** @param topic of which what was said is told; empty for none
   * @param time of what has been [s of the run]; null for the present */
  routine: (topic: string, time: number | null = null) => ofRun<Routine>('routine', { topic }, time),
  topics: () => ofRun<Topics>('topics'),
  scenarios: () => found<Scenarios>('scenarios'),
  scenarioPicture: (id: string) => `api/scenarios/picture?scenario=${encodeURIComponent(id)}`,
  /** @param id of another than the present one */
  scenarioText: (id: string | null) =>
    found<ScenarioText>(`scenarios/text${id === null ? '' : `?scenario=${encodeURIComponent(id)}`}`),
  scenarioSchema: () => found<object>('scenarios/schema'),
  checkText: (wish: TextToCheck) => send('POST', 'scenarios/check', wish) as Promise<TextCheck>,
  saveText: (wish: TextToSave) => send('PUT', 'scenarios/text', wish),
  /** For the robots of all runs, whichever this page shows, and also when that one is over, or was closed. */
  emergencyStop: () => {
    giveWay();
    others.postMessage('emergency stop');
    return send('POST', STOP, {}, false, root());
  },
  check: (wish: Restart) => post('check', wish) as Promise<Plan>,
  restart: (wish: Restart) => post('restart', wish) as Promise<RunInfo>,
  /** Runs one of a sweep again, as it was. */
  watch: (run: SweepRunAgain) => post('watch', run) as Promise<RunInfo>,
  /** Begins another run beside those that are there. */
  startBeside: (wish: Restart) => send('POST', 'beside', wish) as Promise<SeatInfo>,
  sweeps: () => found<SweepState>('sweeps'),
  sweepSize: (wish: SweepWish) => send('POST', 'sweeps/check', wish) as Promise<SweepSize>,
  beginSweep: (wish: SweepWish) => send('POST', 'sweeps', wish),
  /** @param sweep one from before; left out: the newest */
  resumeSweep: (sweep = '') => send('POST', `sweeps/resume?sweep=${encodeURIComponent(sweep)}`),
  stopSweep: () => send('DELETE', 'sweeps'),
  control: () => found<Control>('control'),
  takeControl: (wish: ControlWish) => send('POST', 'control', wish) as Promise<Control>,
  keepControl: () => send('PUT', 'control') as Promise<Control>,
  giveControlBack: () => send('DELETE', 'control', {}, true) as Promise<Control>,
  sweepRuns: (combination: string) =>
    found<SweepRuns>(`sweeps/runs?combination=${encodeURIComponent(combination)}`),
  sweepReport: 'api/sweeps/report',
  sweepsBefore: () => found<SweepsBefore>('sweeps/before'),
  /** @param name of a sweep from before */
  sweepReportOf: (name: string) => `api/sweeps/report?sweep=${encodeURIComponent(name)}`,
  map,
  drawn,
  /** Where robots went before a time [s of the run]; null for the present. */
  trails: (time: number | null) => found<Trails>(time === null ? 'trails' : `trails?time=${String(time)}`),
  /** What a robot's cameras make out. @param time of what has been [s of the run]; null for the present */
  blobs: (robot: string, time: number | null = null) => about<Cameras>('blobs', robot, time),
  /** Where a robot's devices are. @param time of what has been [s of the run]; null for the present */
  mounts: (robot: string, time: number | null = null) => about<Mounts>('mounts', robot, time),
  /** What places cost a robot's navigator, of 100; null when it tells none. */
  costs: (robot: string) => grid(`costs?${query({ robot })}`, robot),
  /** Where the map that a device of a robot has drawn is, to be saved. */
  drawnFiles: (run: number, robot: string, device: string, time: number | null = null) =>
    `api/drawn/${String(run)}/files?${query({ robot, device }, time)}`,
};

/** What can be asked of each of the runs side by side, from the page that shows them all. */
export const seats = {
  /** Where its page is. */
  address: (number: number) => home(number) || './',
  /** Undefined when nobody waited for the answer, as an emergency stop came first. */
  all: async () => {
    const stop = patience.signal;
    return (await found<SideBySide>('beside')) ?? (stop.aborted ? undefined : null);
  },
  info: (number: number) => found<RunInfo>('run', home(number)),
  tell: (number: number, command: string, body: object = {}) =>
    send('POST', `run/${command}`, body, false, home(number)),
  /** @param number of the run from which is taken what is left out */
  start: (number: number, wish: Restart) => send('POST', 'beside', wish, false, home(number)),
  close: (number: number) => send('DELETE', `beside/${String(number)}`),
};

/** How long a look at the run may take, and all else [ms]: one that hangs never answers. */
const LONGEST_LOOK_MILLIS = 5000;
const LONGEST_MILLIS = 30_000;
const STOP = 'run/estop';
/** What is sent also when the page is about to be left. */
const AT_THE_END = new Set<keyof Commands>(['release']);
/** What need not be waited for once a stop is wanted: all that runs may hold up. */
const GIVES_WAY = /^(run|beside)(\/|$)/;
/** What is never given up for a stop: of driving there is one at a time, and whoever drives goes on once it is armed. */
const KEPT = new Set([STOP, 'run/drive', 'run/release']);

/** Of all that an emergency stop need not wait for: a run that hangs keeps connections, of which a browser has six. */
let patience = new AbortController();
/** Other pages of this server, frames among them: they have the same six. */
const others = new BroadcastChannel('rsal');
others.onmessage = giveWay;

function giveWay() {
  patience.abort();
  patience = new AbortController();
}

/** Where the server's own address is, which a reverse proxy may have put below another one. */
const root = () => location.pathname.replace(/(beside\/\d+\/)?[^/]*$/, '');

const home = (number: number) => (number === 1 ? '' : `beside/${String(number)}/`);

const post = (command: string, body: object = {}, evenAtTheEnd = false) =>
  send('POST', `run/${command}`, body, evenAtTheEnd);

/**
 * @param evenAtTheEnd also when the page is about to be left
 * @param home where the run is, when it is not where this page is
 */
async function send(
  method: 'POST' | 'PUT' | 'DELETE',
  what: string,
  body: object = {},
  evenAtTheEnd = false,
  home = '',
): Promise<unknown> {
  let response: Response;
  let answer: unknown;
  const tooLong = AbortSignal.timeout(LONGEST_MILLIS);
  const mayWait = GIVES_WAY.test(what) && !KEPT.has(what);
  const stop = patience.signal;
  try {
    response = await fetch(`${home}api/${what}`, {
      method,
      headers: {
        'Content-Type': 'application/json',
        Authorization: `Bearer ${access.token ?? ''}`,
        ...whoAsks(),
      },
      body: JSON.stringify(body),
      keepalive: evenAtTheEnd,
      signal: mayWait ? AbortSignal.any([stop, tooLong]) : tooLong,
    });
    if (response.status === 401) {
      access.drop();
    }
    answer = await response.json(); // which may be given up, too
  } catch {
    if (mayWait && stop.aborted) {
      throw new RefusedError(texts.refused.stopFirst, []);
    }
    throw new RefusedError(texts.refused.noAnswer, []);
  }
  if (!response.ok) {
    const refused = answer as Refused;
    throw new RefusedError(refused.message, refused.problems, response.status);
  }
  return answer;
}

const patient = () => AbortSignal.any([patience.signal, AbortSignal.timeout(LONGEST_MILLIS)]);

const looking = () => AbortSignal.any([patience.signal, AbortSignal.timeout(LONGEST_LOOK_MILLIS)]);

const whoAsks = () => ({ 'RSAL-Operator': access.id });

/** Which run is asked about: of one before, nobody is to be told what is so in this one. */
let run: number | null = null;

/** @param number of the run that is shown from now on */
export function askAbout(number: number): void {
  run = number;
}

/** What is asked, and of which run and time. */
function query(asked: Record<string, string>, time: number | null = null): string {
  const all = new URLSearchParams(asked);
  if (time !== null) {
    all.set('time', String(time));
  }
  if (run !== null) {
    all.set('run', String(run));
  }
  return all.toString();
}

/** Something about the run that is shown; null when nobody knows any more. */
const ofRun = <T>(what: string, asked: Record<string, string> = {}, time: number | null = null) =>
  found<T>(`${what}?${query(asked, time)}`);

/** Something about a robot; null when nobody knows any more. */
const about = <T>(what: string, robot: string, time: number | null = null) => ofRun<T>(what, { robot }, time);

/** Something to look at; null when nobody knows any more. */
async function found<T>(what: string, home = ''): Promise<T | null> {
  try {
    const response = await fetch(`${home}api/${what}`, { headers: whoAsks(), signal: looking() });
    return response.status === 200 ? ((await response.json()) as T) : null;
  } catch {
    return null;
  }
}

/**
 * The map that a device of a robot has drawn, with its cells as those of `map`; null when there is none any more.
 *
 * @param time of what has been [s of the run]; null for the present
 */
async function drawn(
  run: number,
  robot: string,
  device: string,
  time: number | null = null,
): Promise<Grid | null> {
  return (await grid(`drawn/${String(run)}?${query({ robot, device }, time)}`, robot)) ?? null;
}

/** @param name that it gets; null when there is none, undefined when the server could not say */
async function grid(what: string, name: string): Promise<Grid | null | undefined> {
  try {
    const response = await fetch(`api/${what}`, { signal: looking() });
    if (response.status === 200) {
      return decodeGrid(await response.arrayBuffer(), name);
    }
    return response.status < 500 ? null : undefined;
  } catch {
    return undefined;
  }
}

/** A byte a cell, row by row from the lower left one; null when it isn't there, as when another run has begun meanwhile. */
async function map(run: number): Promise<Uint8Array | null> {
  try {
    const response = await fetch(`api/map/${String(run)}`, { signal: patient() });
    return response.status === 200 ? new Uint8Array(await response.arrayBuffer()) : null;
  } catch {
    return null;
  }
}
