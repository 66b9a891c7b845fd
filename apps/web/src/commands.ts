import { access } from './api/access.svelte';
import { api } from './api/client';
import { live } from './live/live.svelte';
import { attempt } from './notices.svelte';
import { nextSpeed } from './speeds';

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
  faster: () => act(() => api.speed(nextSpeed(live.frame!.speed, 1))),
  slower: () => act(() => api.speed(nextSpeed(live.frame!.speed, -1))),
};

function act(command: () => Promise<unknown>) {
  if (access.allowed && live.frame && !live.over) {
    void attempt(command());
  }
}
