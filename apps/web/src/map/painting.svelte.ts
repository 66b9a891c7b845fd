import type { Grid } from '../api/grid';
import { live } from '../live/live.svelte';
import type { CellMaps } from './cellmaps.svelte';
import {
  drawFloor,
  paintCosts,
  paintDrawn,
  paintFloor,
  paintWalls,
  poolOf,
  wallColors,
} from './layers/floor';
import { drawGrid } from './layers/grid';
import { wallHeight } from './layers/heights';
import { drawRelief, reliefOf, sidesOf } from './layers/relief';
import {
  drawStillThings,
  drawThingsUnderWalls,
  drawWallsOver,
  numbersOf,
  standingOf,
  thingsUnderWalls,
} from './layers/things';
import { Uprights, wallsOf } from './layers/uprights';
import { layers } from './layers.svelte';
import type { Palette } from './palette';
import { View } from './view';

/** What is painted, as it is now. */
export interface Painted {
  view: View;
  palette: Palette | null;
  costs: Grid | null;
  /** Numbers of those things that the floor is drawn without. */
  away: ReadonlySet<number>;
}

/** Floor, walls and still things: what stays the same from frame to frame, painted again when it changes. */
export class Painting {
  private readonly now: () => Painted;
  private readonly maps: CellMaps;

  private readonly oblique = $derived.by(() => this.now().view.oblique);
  private readonly turned = $derived.by(() => this.now().view.turn);
  private readonly palette = $derived.by(() => this.now().palette);
  private readonly away = $derived.by(() => this.now().away);
  private readonly pool = $derived.by(() => this.maps.floor && poolOf(this.maps.floor.map, this.now().view));

  /** The shorter side of the map [m]. */
  readonly worldSide = $derived.by(() =>
    live.info ? Math.min(live.info.map.width, live.info.map.height) * live.info.map.resolution : Infinity,
  );

  /** Things that walls are drawn over. */
  private readonly lower = $derived.by(() => {
    const { floor } = this.maps;
    return floor
      ? thingsUnderWalls(live.things, this.away, floor.map, floor.bytes, this.oblique, this.worldSide)
      : [];
  });

  /** Walls that are drawn over something. */
  private readonly tops = $derived.by(() => {
    const { floor } = this.maps;
    const { palette, pool } = this;
    return (this.oblique || this.lower.length > 0) && floor && pool && palette
      ? paintWalls(floor.map, floor.bytes, pool, this.oblique ? palette.standing : palette.occupied)
      : null;
  });
  private readonly sides = $derived.by(() => {
    const { floor } = this.maps;
    return this.oblique && floor && this.pool ? sidesOf(floor.map, floor.bytes, this.pool) : null;
  });
  private readonly relief = $derived.by(() => {
    const { up } = new View(1, 0, 0, { turn: this.turned, oblique: this.oblique });
    const { floor } = this.maps;
    return this.sides && floor && this.palette
      ? reliefOf(this.sides, up, wallColors(floor.map, this.palette.standing), wallHeight(floor.map))
      : null;
  });
  private readonly walls = $derived.by(() => {
    const { floor } = this.maps;
    return this.oblique && floor ? wallsOf(floor.map, floor.bytes) : null;
  });

  private readonly hidingThings = $derived.by(
    () =>
      this.walls &&
      new Uprights([...this.walls, ...standingOf(live.things, this.away, this.worldSide, false)]),
  );

  /** What hides robots. */
  readonly hidingRobots = $derived.by(
    () =>
      this.walls &&
      new Uprights([...this.walls, ...standingOf(live.things, this.away, this.worldSide, true)]),
  );

  private readonly floor = $derived.by(() => {
    const { floor } = this.maps;
    return floor && this.pool && this.palette && paintFloor(floor.map, floor.bytes, this.pool, this.palette);
  });
  private readonly drawn = $derived.by(() => {
    const { drawn } = this.maps;
    const { view } = this.now();
    return drawn && this.palette && paintDrawn(drawn.map, drawn.bytes, poolOf(drawn.map, view), this.palette);
  });
  private readonly costs = $derived.by(() => {
    const { costs, view } = this.now();
    return costs && this.palette && paintCosts(costs.map, costs.bytes, poolOf(costs.map, view), this.palette);
  });

  constructor(maps: CellMaps, now: () => Painted) {
    this.maps = maps;
    this.now = now;
  }

  /** @param context in CSS pixels */
  paint(context: CanvasRenderingContext2D, palette: Palette, width: number, height: number) {
    const { view } = this.now();
    context.fillStyle = palette.unknown;
    context.fillRect(0, 0, width, height);
    if (this.floor && layers.shown.floor) {
      drawFloor(context, this.floor, view);
    }
    if (this.drawn && this.maps.hasDrawn && layers.shown.map) {
      drawFloor(context, this.drawn, view);
    }
    if (this.costs) {
      drawFloor(context, this.costs, view);
    }
    if (layers.shown.grid) {
      drawGrid(context, view, palette, width, height);
    }
    drawThingsUnderWalls(context, this.lower, view, palette, this.worldSide);
    if (this.tops && layers.shown.floor) {
      if (this.relief) {
        const tall = wallHeight(this.maps.floor!.map);
        drawRelief(context, this.relief, view, height, tall);
        drawFloor(context, this.tops, view, tall);
      } else {
        drawWallsOver(context, this.lower, this.tops, view);
      }
    }
    const left = numbersOf(this.lower, this.away);
    drawStillThings(
      context,
      live.things,
      left,
      view,
      palette,
      width,
      height,
      this.worldSide,
      this.hidingThings,
    );
  }
}
