import { SvelteMap } from 'svelte/reactivity';
import { api } from '../api/client';
import { live } from '../live/live.svelte';
import { Series } from './series';
import type { View, Window } from './window';

/** What can be plotted: a number of a device of a robot. */
export interface Plottable {
  readonly robot: string;
  readonly device: string;
  readonly number: string;
  readonly title: string;
  readonly unit: string;
}

export interface Plotted extends Plottable {
  readonly series: Series;
}

export const keyOf = ({ robot, device, number }: Pick<Plottable, 'robot' | 'device' | 'number'>) =>
  `${robot}: ${device} ${number}`.trim();

/** What this operator plots, until it is closed: whichever robot is selected, and whenever is looked at. */
class Plots {
  /** By {@link keyOf}. */
  readonly all = new SvelteMap<string, Plotted>();
  /** Which of them are together in one, in the order in which they came. */
  groups = $state.raw<readonly (readonly string[])[]>([]);
  /** Changes when any of them has grown. */
  beat = $state(0);
  /** How much of the past they show at most [s]. */
  span = $state(60);
  /** What they show instead, all of them the same. */
  view = $state.raw<View | null>(null);

  private run = 0;

  /** @param group to which it is added; a new one when left out */
  add(one: Plottable, group?: readonly string[]) {
    const key = keyOf(one);
    if (this.all.has(key)) {
      return;
    }
    this.all.set(key, { ...one, series: new Series() });
    this.groups = group
      ? this.groups.map((each) => (each === group ? [...each, key] : each))
      : [...this.groups, [key]];
    void this.readPast();
  }

  remove(key: string) {
    this.all.delete(key);
    this.groups = this.groups
      .map((group) => group.filter((one) => one !== key))
      .filter(({ length }) => length > 0);
  }

  /** Begins anew with each run: of robots that it has as well, the same is plotted. */
  begin(run: number, robots: readonly string[]) {
    if (run === this.run) {
      return;
    }
    this.run = run;
    this.view = null;
    [...this.all].forEach(([key, one]) => {
      if (robots.includes(one.robot)) {
        this.all.set(key, { ...one, series: new Series() });
      } else {
        this.remove(key);
      }
    });
  }

  /** Takes over what the server knows of them; of a recording that is all that they ever are. */
  async readPast() {
    await Promise.all(
      [...this.all.values()].map(async ({ robot, device, number, series }) => {
        if (series.isWhole) {
          return;
        }
        const past = await api.pastNumbers(robot, device, number);
        if (past !== null && live.recording) {
          series.learn(past.times, past.values);
        } else if (past !== null) {
          series.merge(past.times, past.values);
        }
      }),
    );
    this.beat++;
  }

  /** From the oldest to the newest of them; from ∞ to −∞ when there is none. */
  get known(): Window {
    const all = [...this.all.values()].map(({ series }) => series);
    return {
      from: Math.min(...all.map(({ from }) => from)),
      until: Math.max(...all.map(({ until }) => until)),
    };
  }
}

export const plots = new Plots();
