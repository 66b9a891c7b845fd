import { untrack } from 'svelte';
import { api } from '../api/client';
import type { MapInfo } from '../api/messages';
import { live } from '../live/live.svelte';
import { selection } from '../selection.svelte';
import { layers } from './layers.svelte';

/** After which a map is asked for again. */
const AGAIN_MILLIS = 1000;
/** Such a pause grows to this while the map is not there. */
const SELDOM_MILLIS = 30_000;
/** How long details may be before their frame. */
const LATE_MILLIS = 300;

/** The cells of a map. */
export interface Cells {
  /** Of which run, see Live.told. */
  told: number;
  map: MapInfo;
  bytes: Uint8Array;
}

/** The cells of maps, fetched when they are wanted: of the run's map, and of one that a robot has drawn. */
export class CellMaps {
  /** Of the run's map. */
  floor = $state.raw<Cells | null>(null);

  private fetched = $state.raw<(Cells & { by: string; time: number }) | null>(null);
  private fetching = $state(false); // a map that a robot has drawn
  private missing = $state(0); // how often one was not there
  private missed = $state(0); // maps that did not come
  private asked = ''; // of maps that robots draw the one that was asked for last
  private askedOf = ''; // in which run, and of which robot, that was
  private pause = AGAIN_MILLIS; // before one that was not there is asked for again

  /** Draws the map that is shown: the selected robot, or else the first that draws one. */
  private readonly drawer = $derived.by(() => {
    const drawers = live.details?.robots.filter((robot) => robot.maps.length > 0) ?? [];
    const selected = live.idOf(selection.robot);
    return drawers.find(({ id }) => id === selected) ?? drawers[0] ?? null;
  });
  private readonly wanted = $derived.by(() => this.drawer && layers.drawn(this.drawer.maps));
  private readonly by = $derived.by(() =>
    this.drawer && this.wanted ? `${this.drawer.id} ${this.wanted.device}` : '',
  );

  /** Which a robot of this run has drawn, maybe not the one that is wanted. */
  readonly drawn = $derived.by((): Cells | null => (this.fetched?.told === live.told ? this.fetched : null));

  /** Whether that map is by whom it should be and of then: anyone who looks back waits for it. */
  readonly hasDrawn = $derived.by(
    () =>
      !!this.fetched && !!this.wanted && this.fetched.by === this.by && this.fetched.time <= this.wanted.time,
  );

  /** Follows the run from now on; while a component is made. */
  constructor() {
    $effect(() => this.askForFloor());
    $effect(() => this.askForDrawn());
  }

  private askForFloor() {
    const { told } = live;
    const run = untrack(() => live.info);
    void this.missed;
    if (run && this.floor?.told !== told && live.connection === 'open') {
      void api.map(run.number).then((bytes) => {
        if (bytes === null) {
          setTimeout(() => this.missed++, AGAIN_MILLIS);
        } else if (live.told === told) {
          this.floor = { told, map: run.map, bytes };
        }
      });
    }
  }

  private askForDrawn() {
    const run = live.info?.number;
    const { told } = live;
    const { drawer, by, wanted: next } = this;
    void this.missing;
    if (
      run === undefined ||
      !drawer ||
      !next ||
      !layers.shown.map ||
      this.fetching ||
      live.connection !== 'open'
    ) {
      return;
    }
    const wanted = `${told} ${by} ${next.time}`;
    if (wanted === this.asked) {
      return;
    }
    const of = `${told} ${by}`;
    if (of !== this.askedOf) {
      this.askedOf = of;
      this.pause = AGAIN_MILLIS;
    }
    this.asked = wanted;
    this.fetching = true;
    void drawnNow(run, drawer.id, next.device).then((map) => {
      this.fetching = false;
      if (map === null) {
        this.askAgainFor(wanted);
        return;
      }
      this.pause = AGAIN_MILLIS;
      if (live.told === told) {
        this.fetched = { told, by, time: next.time, ...map };
      }
    });
  }

  private askAgainFor(wanted: string) {
    setTimeout(() => {
      if (this.asked === wanted) {
        this.asked = '';
        this.missing++;
      }
    }, this.pause);
    this.pause = Math.min(2 * this.pause, SELDOM_MILLIS);
  }
}

/** Of what has been when the frame is there to which the details belong that tell of it: those come first. */
async function drawnNow(run: number, robot: string, device: string) {
  if (!live.past) {
    return api.drawn(run, robot, device);
  }
  await new Promise<void>((resolve) => {
    const come = () => {
      heard();
      resolve();
    };
    const heard = live.onEachFrame(come);
    setTimeout(come, LATE_MILLIS); // it was there already, and nothing moves
  });
  return live.newest && api.drawn(run, robot, device, live.newest.frame.time);
}
