import { nextSpeed, valueOf } from './speeds';

/** How long the run may take to tell its new speed [ms]. */
const PATIENCE = 1000;

/**
 * The speed that a person wants. Fast presses count from what was wanted last, not from what the run last told. One
 * request is under way at a time, so that what was wanted last is what the run hears last.
 */
export class WantedSpeed {
  private wanted: string | null = null;
  private asking = false;
  private forgetting: ReturnType<typeof setTimeout> | undefined;

  /** @param ask asks the run; whether it will */
  constructor(private readonly ask: (speed: string) => Promise<boolean>) {}

  /** @param told what the run last told, as times real time */
  change(direction: 1 | -1, told: number): Promise<boolean> {
    return this.set(nextSpeed(this.wanted === null ? told : valueOf(this.wanted), direction));
  }

  /** @returns whether it will, as far as that is known yet */
  async set(speed: string): Promise<boolean> {
    this.wanted = speed;
    if (this.asking) {
      return true;
    }
    clearTimeout(this.forgetting);
    this.asking = true;
    try {
      return await this.askUntilHeard();
    } finally {
      this.asking = false;
      this.forgetting = setTimeout(() => (this.wanted = null), PATIENCE);
    }
  }

  private async askUntilHeard(): Promise<boolean> {
    for (let asked: string | null = null; asked !== this.wanted;) {
      asked = this.wanted;
      if (asked !== null && !(await this.ask(asked))) {
        this.wanted = null;
        return false;
      }
    }
    return true;
  }
}
