import type { DrawnMap } from '../api/messages';
import { drawAxes } from './layers/axes';
import { drawBlobs } from './layers/blobs';
import { drawCones } from './layers/cones';
import { drawDraft } from './layers/drafts';
import { drawEstimates } from './layers/estimates';
import { drawGoals } from './layers/goals';
import { drawLinks } from './layers/links';
import { drawNames } from './layers/names';
import { drawParticles } from './layers/particles';
import { drawMotion, drawPaths } from './layers/paths';
import { drawRobots } from './layers/robots';
import { drawScans } from './layers/scans';
import { drawStanding } from './layers/standing';
import { drawMovedThings, drawThingsOverhead } from './layers/things';
import { drawTape } from './layers/tape';
import { drawTrails } from './layers/trails';
import type { Layer } from './scene';

export type Switchable =
  | 'floor'
  | 'grid'
  | 'map'
  | 'costs'
  | 'scans'
  | 'cones'
  | 'blobs'
  | 'particles'
  | 'trails'
  | 'paths'
  | 'motion'
  | 'goals'
  | 'estimates'
  | 'links'
  | 'axes'
  | 'names';

type Ordered = [Switchable | null, Layer][];

/**
 * What lies on the floor, from there up; drawn when a frame comes. The map, the grid, maps that robots draw, costs, and things that were
 * not moved, are drawn with the floor.
 */
const lying: Ordered = [
  ['scans', drawScans],
  ['cones', drawCones],
  ['trails', drawTrails],
  ['paths', drawPaths],
  ['motion', drawMotion],
  ['goals', drawGoals],
];

/** What is drawn over that, again and again between two frames: what stands there and moves, and what is said of it. */
const bodies: Ordered = [
  ['blobs', drawBlobs],
  ['links', drawLinks],
  [null, drawMovedThings],
  [null, drawRobots],
];
const above: Ordered = [
  [null, drawThingsOverhead],
  ['particles', drawParticles],
  ['estimates', drawEstimates],
  ['axes', drawAxes],
  ['names', drawNames],
  [null, drawDraft],
  [null, drawTape],
];
/** In an oblique view they are drawn by their depth. */
const obliqueBodies: Ordered = [
  ['blobs', drawBlobs],
  ['links', drawLinks],
  [null, drawStanding],
];

class Layers {
  shown = $state<Record<Switchable, boolean>>({
    floor: true,
    grid: true,
    map: true,
    costs: false,
    scans: true,
    cones: false,
    blobs: false,
    particles: true,
    trails: true,
    paths: true,
    motion: true,
    goals: true,
    estimates: true,
    links: false,
    axes: false,
    names: true,
  });

  /** Name of the device whose map is drawn, of a robot with several that draw one; of others the first is. */
  mapper = $state('');

  /** Of maps that a robot has drawn, the one to be seen. */
  drawn(maps: DrawnMap[]): DrawnMap | undefined {
    return maps.find(({ device }) => device === this.mapper) ?? maps[0];
  }

  get lying(): Layer[] {
    return this.visible(lying);
  }

  standing(oblique: boolean): Layer[] {
    return this.visible([...(oblique ? obliqueBodies : bodies), ...above]);
  }

  private visible(order: Ordered): Layer[] {
    return order.filter(([name]) => name === null || this.shown[name]).map(([, layer]) => layer);
  }
}

export const layers = new Layers();
