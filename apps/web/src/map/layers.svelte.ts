import { drawCones } from './layers/cones';
import { drawDraft } from './layers/drafts';
import { drawEstimates } from './layers/estimates';
import { drawGoals } from './layers/goals';
import { drawNames } from './layers/names';
import { drawParticles } from './layers/particles';
import { drawPaths } from './layers/paths';
import { drawRobots } from './layers/robots';
import { drawScans } from './layers/scans';
import { drawMovedThings, drawThingsOverhead } from './layers/things';
import { drawTape } from './layers/tape';
import { drawTrails } from './layers/trails';
import type { Layer } from './scene';

export type Switchable =
  'grid' | 'map' | 'scans' | 'cones' | 'particles' | 'trails' | 'paths' | 'goals' | 'estimates' | 'names';

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
  ['names', drawNames],
  [null, drawDraft],
  [null, drawTape],
];

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
    names: true,
  });

  get visible(): Layer[] {
    return order.filter(([name]) => name === null || this.shown[name]).map(([, layer]) => layer);
  }
}

export const layers = new Layers();
