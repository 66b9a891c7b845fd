import { drawAxes } from './layers/axes';
import { drawCones } from './layers/cones';
import { drawDraft } from './layers/drafts';
import { drawEstimates } from './layers/estimates';
import { drawGoals } from './layers/goals';
import { drawNames } from './layers/names';
import { drawParticles } from './layers/particles';
import { drawPaths } from './layers/paths';
import { drawRobots } from './layers/robots';
import { drawScans } from './layers/scans';
import { drawStanding } from './layers/standing';
import { drawMovedThings, drawThingsOverhead } from './layers/things';
import { drawTape } from './layers/tape';
import { drawTrails } from './layers/trails';
import type { Layer } from './scene';

export type Switchable =
  | 'grid'
  | 'map'
  | 'scans'
  | 'cones'
  | 'particles'
  | 'trails'
  | 'paths'
  | 'goals'
  | 'estimates'
  | 'axes'
  | 'names';

/** From the floor up. The grid, maps that robots draw, and things that were not moved, are drawn with the floor. */
const order: [Switchable | null, Layer][] = [
  [null, drawMovedThings],
  ['scans', drawScans],
  ['cones', drawCones],
  ['trails', drawTrails],
  ['paths', drawPaths],
  ['goals', drawGoals],
  [null, drawRobots],
  [null, drawThingsOverhead],
  ['particles', drawParticles],
  ['estimates', drawEstimates],
  ['axes', drawAxes],
  ['names', drawNames],
  [null, drawDraft],
  [null, drawTape],
];

/** What of it lies on the floor, seen through walls in an oblique view; all else is drawn over what stands. */
const lying = new Set<Layer>([drawScans, drawCones, drawTrails, drawPaths, drawGoals]);
/** In an oblique view these are drawn together, by their depth. */
const bodies = new Set<Layer>([drawMovedThings, drawRobots]);

class Layers {
  shown = $state<Record<Switchable, boolean>>({
    grid: true,
    map: true,
    scans: true,
    cones: false,
    particles: true,
    trails: true,
    paths: true,
    goals: true,
    estimates: true,
    axes: false,
    names: true,
  });

  get visible(): Layer[] {
    return order.filter(([name]) => name === null || this.shown[name]).map(([, layer]) => layer);
  }

  /** Of an oblique view, on the floor. */
  get lying(): Layer[] {
    return this.visible.filter((layer) => lying.has(layer));
  }

  /** Of an oblique view, over that. */
  get standing(): Layer[] {
    return [drawStanding, ...this.visible.filter((layer) => !lying.has(layer) && !bodies.has(layer))];
  }
}

export const layers = new Layers();
