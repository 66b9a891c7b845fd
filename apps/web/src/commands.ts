import { access } from './api/access.svelte';
import { api } from './api/client';
import type { LookBack, RobotPose } from './api/messages';
import { driving } from './driving/driving.svelte';
import { framed } from './framed';
import { look } from './live/connection';
import { live } from './live/live.svelte';
import { attempt } from './notices.svelte';
import { nameOf, nextSpeed } from './speeds';
import { WantedSpeed } from './wantedspeed';

const wanted = new WantedSpeed((speed) => attempt(api.speed(speed)));

/** What buttons and keys do to the run. Nothing happens where nothing can. */
export const commands = {
  /** Of the run as it is now, also for who looks back; and of those beside it, also when it is over itself. */
  emergencyStop: () => {
    if (access.operator && live.frame !== null && !live.recording && (framed || live.past || !live.over)) {
      void attempt(api.emergencyStop());
      commands.toPresent(); // where what became of it is seen, and armed again
    }
  },
  rearm: () => act(api.rearm),
  pause: () => (live.past ? play() : act(() => (live.frame!.paused ? api.resume() : api.pause()))),
  step: () => {
    if (live.past) {
      go({ step: 1 });
    } else if (live.frame?.paused) {
      act(() => api.step());
    }
  },
  faster: () => change(1),
  slower: () => change(-1),
  /** @returns whether it will */
  speed: (factor: string) => {
    if (live.past) {
      go({ speed: factor, playing: live.going });
      return Promise.resolve(true);
    }
    return wanted.set(factor);
  },
  stepBack: () => go({ step: -1 }),
  /** Looks at another time [s of the run]. */
  seek: (time: number) => go({ time, playing: live.past && live.going }),
  /** The event that is marked before what is shown, or after it. */
  eventBefore: () => seekTo(live.marked.findLast(({ time }) => time < shown() - 0.05)?.time),
  eventAfter: () => seekTo(live.marked.find(({ time }) => time > Math.max(shown() + 0.05, sought))?.time),
  toPresent: () => {
    if (live.past && !live.recording) {
      look({ live: true });
    }
  },
};

/** Sends a robot somewhere, which ends this page's driving it. */
export async function send(to: RobotPose): Promise<void> {
  if (driving.robot === to.robot) {
    await driving.letGo();
  }
  await attempt(api.goal(to));
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
function play() {
  const { until, from } = live.reach ?? { until: Infinity, from: 0 };
  const ended = live.recording !== null && shown() >= until;
  go({ time: live.frame!.paused && ended ? from : null, playing: live.frame!.paused });
}

function go(wish: Partial<LookBack>) {
  sought = -Infinity;
  if (live.newest) {
    const { frame } = live.newest;
    look({ time: frame.past ? null : frame.time, speed: frame.past ? nameOf(frame.speed) : '1', ...wish });
  }
}

function change(direction: 1 | -1) {
  if (live.past) {
    go({ speed: nextSpeed(live.frame!.speed, direction), playing: live.going });
    return;
  }
  if (mayAct()) {
    void wanted.change(direction, live.frame!.speed);
  }
}

function act(command: () => Promise<unknown>) {
  if (mayAct()) {
    void attempt(command());
  }
}

function mayAct(): boolean {
  return access.allowed && live.frame !== null && !live.over;
}
