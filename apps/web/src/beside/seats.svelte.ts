import { tick } from 'svelte';
import { api, seats as ask } from '../api/client';
import type { SeatInfo, SideBySide } from '../api/messages';
import { attempt } from '../notices.svelte';
import { valueOf } from '../speeds';
import { texts } from '../texts';

const PERIOD_MILLIS = 500;

/** The runs side by side, as the server last told them. */
class Seats {
  private told = $state.raw<SideBySide | null>(null);
  private looks = 0;
  /** Numbers of runs that were closed here: their frames go first, so that none asks about a run that is gone. */
  private closed = $state.raw<readonly number[]>([]);
  connection = $state<'connecting' | 'open' | 'gone'>('connecting');

  get runs(): readonly SeatInfo[] {
    return this.told?.runs.filter(({ number }) => !this.closed.includes(number)) ?? [];
  }

  /** Those that are not over. */
  get going(): readonly SeatInfo[] {
    return this.runs.filter(({ outcome }) => outcome === '');
  }

  get full(): boolean {
    return this.told !== null && this.told.runs.length >= this.told.most;
  }

  get most(): number {
    return this.told?.most ?? 0;
  }

  /** Whether time stands still in all that go on. */
  get paused(): boolean {
    return this.going.length > 0 && this.going.every(({ paused }) => paused);
  }

  /** That all have that go on; null when they differ. */
  get speed(): string | null {
    const speeds = new Set(this.going.map(({ speed }) => valueOf(speed)));
    return speeds.size === 1 ? this.going[0]!.speed : null;
  }

  /** Asks how they are, again and again. */
  async follow(): Promise<void> {
    await this.look();
    setTimeout(() => void this.follow(), PERIOD_MILLIS);
  }

  private async look(): Promise<void> {
    const mine = ++this.looks;
    const told = await ask.all();
    if (mine !== this.looks) {
      return; // somebody has asked since, perhaps as something was changed
    }
    if (told) {
      this.connection = 'open';
      this.told = told;
    } else if (told === null) {
      this.connection = 'gone';
    }
  }

  /** Tells some of them, all at once; what one refuses is shown. */
  async tell(
    some: readonly SeatInfo[],
    command: string,
    body: (run: SeatInfo) => object = () => ({}),
  ): Promise<void> {
    await Promise.all(some.map((run) => attempt(ask.tell(run.number, command, body(run)))));
    await this.look();
  }

  /** All robots of all runs: whichever is asked, the server stops them all. */
  async emergencyStop(): Promise<void> {
    await attempt(api.emergencyStop(), true);
    await this.look();
  }

  async close(run: SeatInfo): Promise<void> {
    this.closed = [...this.closed, run.number];
    await tick(); // frames are gone
    if (!(await attempt(ask.close(run.number)))) {
      this.closed = this.closed.filter((number) => number !== run.number);
    }
    await this.look();
  }
}

/** What tells a run from the others, in words. */
export const details = ({ configuration, seed, typed, mas }: SeatInfo): string =>
  texts.beside.details(
    configuration,
    seed,
    Object.entries(typed).map(([name, value]) => `${name} ${value}`),
    mas,
  );

export const seats = new Seats();
