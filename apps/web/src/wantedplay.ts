/** How long the server may take to show what was wished [ms]. */
const PATIENCE = 1000;

/**
 * Whether what has been is to go on by itself. What was wished last counts until a frame tells so: who pauses and jumps
 * at once means to stay where that leads.
 */
export class WantedPlay {
  private wish: { playing: boolean; at: number } | null = null;

  wants(playing: boolean) {
    this.wish = { playing, at: performance.now() };
  }

  /** @param told whether it goes on, as the newest frame tells */
  is(told: boolean): boolean {
    if (this.wish?.playing === told || performance.now() > (this.wish?.at ?? 0) + PATIENCE) {
      this.wish = null;
    }
    return this.wish?.playing ?? told;
  }
}
