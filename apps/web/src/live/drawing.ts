import { live } from './live.svelte';

/**
 * Draws when there is something to draw, once for each picture of the screen and no more: a page in which nothing moves
 * leaves the processor to the run.
 */
export class Drawing {
  private request = 0;

  /** @param draw returns whether it is to draw the next picture, too; its `now` is that of performance.now() */
  constructor(private readonly draw: (now: number) => boolean) {}

  /** There is something to draw. */
  wake() {
    this.request ||= requestAnimationFrame((now) => {
      this.request = 0;
      if (this.draw(now)) {
        this.wake();
      }
    });
  }

  /** Draws each frame that comes, too, until what it returns is called. */
  follow(): () => void {
    const leave = live.onEachFrame(() => this.wake());
    this.wake();
    return () => {
      leave();
      cancelAnimationFrame(this.request);
      this.request = 0;
    };
  }
}
