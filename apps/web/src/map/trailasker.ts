import { api } from '../api/client';
import { live } from '../live/live.svelte';
import type { Trails } from '../live/trails';

/** After which it is asked again where robots went: who drags the cursor looks elsewhere all the time. */
const TRAILS_MILLIS = 200;

/** Asks where robots went before: one question after the other, as of where one looks meanwhile the newest counts. */
export class TrailAsker {
  private asking = false;
  private again = false;

  /** @param learned told when there is more of them */
  constructor(
    private readonly trails: Trails,
    private readonly learned: () => void,
  ) {}

  async ask(): Promise<void> {
    this.again = this.asking;
    if (this.asking) {
      return;
    }
    this.asking = true;
    do {
      this.again = false;
      const { frame } = live.newest!;
      const told = await api.trails(frame.past ? frame.time : null);
      if (told !== null) {
        this.trails.learn(told, frame);
        this.learned();
      }
      await new Promise((resolve) => setTimeout(resolve, TRAILS_MILLIS));
    } while (this.again && live.newest !== null);
    this.asking = false;
  }
}
