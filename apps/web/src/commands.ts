import { access } from './api/access.svelte';
import { api } from './api/client';
import type { RobotPose } from './api/messages';
import { driving } from './driving/driving.svelte';
import { live } from './live/live.svelte';
import { attempt } from './notices.svelte';
import { WantedSpeed } from './wantedspeed';

const wanted = new WantedSpeed((speed) => attempt(api.speed(speed)));

/** What buttons and keys do to the run. Nothing happens where nothing can. */
export const commands = {
  emergencyStop: () => act(api.emergencyStop),
  rearm: () => act(api.rearm),
  pause: () => act(() => (live.frame!.paused ? api.resume() : api.pause())),
  step: () => {
    if (live.frame?.paused) {
      act(() => api.step());
    }
  },
  faster: () => change(1),
  slower: () => change(-1),
  /** @returns whether it will */
  speed: (factor: string) => wanted.set(factor),
};

/** Sends a robot somewhere, which ends this page's driving it. */
export async function send(to: RobotPose): Promise<void> {
  if (driving.robot === to.robot) {
    await driving.letGo();
  }
  await attempt(api.goal(to));
}

function change(direction: 1 | -1) {
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
