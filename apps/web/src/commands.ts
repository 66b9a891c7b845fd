import { access } from './api/access.svelte';
import { api } from './api/client';
import type { Commands, LookBack } from './api/messages';
import { ABOUT_CONTROL } from './control/control.svelte';
import { driving } from './driving/driving.svelte';
import { look } from './live/connection';
import { live } from './live/live.svelte';
import { attempt, notices } from './notices.svelte';
import { nameOf, nextSpeed } from './speeds';
import { texts } from './texts';
import { WantedPlay } from './wantedplay';
import { WantedSpeed } from './wantedspeed';

const wanted = new WantedSpeed((speed) => attempt(api.tell('speed', { factor: speed })));
const play = new WantedPlay();
/** Whether what is looked back on goes on by itself, or will. */
const plays = () => live.past && play.is(live.going);

/** What buttons and keys do to the run. Nothing happens where nothing can. */
export const commands = {
  /** Of all runs as they are now, also for who looks back, and when this one is over. */
  emergencyStop: () => {
    if (live.recording) {
      return;
    }
    if (!access.operator) {
      notices.add(texts.access.why); // or who watches might think that robots stand still
      return;
    }
    const over = live.over;
    void attempt(api.emergencyStop(), true).then((done) => {
      if (done && over) {
        notices.add(texts.run.stoppedOver);
      }
    });
    commands.toPresent(); // where what became of it is seen, and armed again
  },
  /** As they are now, also for who looks back, and sees then what moves. */
  rearm: () => {
    if (live.past && live.recording === null && access.mayArm) {
      void attempt(api.tell('rearm', {}));
      commands.toPresent();
    } else {
      act(() => api.tell('rearm', {}));
    }
  },
  /** Whether the run can be changed from here; if not, says why. */
  mayAct: (): boolean => {
    if (access.allowed && live.frame !== null && !live.over) {
      return true;
    }
    const why = commands.whyNot();
    if (why !== null) {
      notices.add(why, false, access.elsewhere === null ? null : ABOUT_CONTROL);
    }
    return false;
  },
  /** Why the run can't be changed from here. Null when that is plain to see, or it can. */
  whyNot: (): string | null => {
    if (live.recording || live.frame === null) {
      return null;
    }
    if (!access.operator) {
      return texts.access.why;
    }
    if (access.elsewhere !== null) {
      return texts.control.onlyWatch(access.elsewhere);
    }
    return live.past ? texts.access.past : live.over ? texts.access.over : null;
  },
  pause: () => (live.past ? toggle() : act(() => api.tell(live.frame!.paused ? 'resume' : 'pause', {}))),
  step: () => {
    if (live.past) {
      go({ step: 1 });
    } else if (live.frame?.paused) {
      act(() => api.tell('step', {}));
    }
  },
  faster: () => change(1),
  slower: () => change(-1),
  /** @returns whether it will */
  speed: (factor: string) => {
    if (live.past) {
      go({ speed: factor, playing: plays() });
      return Promise.resolve(true);
    }
    return wanted.set(factor);
  },
  stepBack: () => go({ step: -1 }),
  /** Looks at another time [s of the run]. */
  seek: (time: number) => go({ time, playing: plays() }),
  /** The event that is marked before what is shown, or after it. */
  eventBefore: () => seekTo(live.marked.findLast(({ time }) => time < shown() - 0.05)?.time),
  eventAfter: () => seekTo(live.marked.find(({ time }) => time > Math.max(shown() + 0.05, sought))?.time),
  toPresent: () => {
    if (live.lookingBack) {
      look({ live: true });
    }
  },
};

/** Sends a robot somewhere, which ends this page's driving it. */
export async function send(to: Commands['goal']['takes']): Promise<void> {
  if (driving.robot === to.robot) {
    await driving.letGo();
  }
  await attempt(api.tell('goal', to));
}

const shown = () => live.newest?.frame.time ?? 0;

/** The event that was sought last: what is shown of it may be a little older. */
let sought = -Infinity;

function seekTo(time: number | undefined) {
  if (time !== undefined) {
    commands.seek(time);
    sought = time;
  }
}

/** On from where it was; from the beginning, if it was at the end. */
function toggle() {
  const { until, from } = live.reach ?? { until: Infinity, from: 0 };
  const ended = live.recording !== null && shown() >= until;
  const stands = !plays();
  go({ time: stands && ended ? from : null, playing: stands });
}

function go(wish: Partial<LookBack>) {
  sought = -Infinity;
  play.wants(wish.playing ?? false);
  if (live.newest) {
    const { frame } = live.newest;
    look({ time: frame.past ? null : frame.time, speed: frame.past ? nameOf(frame.speed) : '1', ...wish });
  }
}

function change(direction: 1 | -1) {
  if (live.past) {
    go({ speed: nextSpeed(live.frame!.speed, direction), playing: plays() });
    return;
  }
  if (commands.mayAct()) {
    void wanted.change(direction, live.frame!.speed);
  }
}

function act(command: () => Promise<unknown>) {
  if (commands.mayAct()) {
    void attempt(command());
  }
}
