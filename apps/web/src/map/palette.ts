import { channelsOf } from '../shades';

/** Colors of the map, from the style sheet, so that light and dark are decided in one place. */
export interface Palette {
  free: string;
  occupied: string;
  /** Of what is occupied, in an oblique view: its sides are darker. */
  standing: string;
  unknown: string;
  /** What a robot sees above, and of the floor, which is tiled. */
  sky: string;
  ground: string;
  tile: string;
  /** Of maps that robots draw. */
  drawn: string;
  drawnWall: string;
  /** Of places that cost a robot much, and of those where it can't be. */
  dear: string;
  blocked: string;
  grid: string;
  text: string;
  halo: string;
  /** Around things. */
  edge: string;
  /** Of what is selected. */
  accent: string;
}

export function readPalette(element: Element): Palette {
  const style = getComputedStyle(element);
  const color = (name: string) => style.getPropertyValue(`--map-${name}`).trim();
  return {
    free: color('free'),
    occupied: color('occupied'),
    standing: color('standing'),
    unknown: color('unknown'),
    sky: color('sky'),
    ground: color('ground'),
    tile: color('tile'),
    drawn: color('drawn'),
    drawnWall: color('drawn-wall'),
    dear: color('dear'),
    blocked: color('blocked'),
    grid: color('grid'),
    text: color('text'),
    halo: color('halo'),
    edge: color('edge'),
    accent: color('accent'),
  };
}

/** Red, green and blue of a color that a style sheet may have. */
export function rgb(color: string): [number, number, number] {
  const context = new OffscreenCanvas(1, 1).getContext('2d')!;
  context.fillStyle = color;
  context.fillRect(0, 0, 1, 1);
  const [red, green, blue] = context.getImageData(0, 0, 1, 1).data;
  return [red!, green!, blue!];
}

const STEPS = 32;
const shades = new Map<string, string[]>();

/**
 * A color in less light, as sides of bodies have it.
 *
 * @param color `#rrggbb`
 * @param light 1 for all, 0 for none
 */
export function shaded(color: string, light: number): string {
  let all = shades.get(color);
  if (!all) {
    all = [];
    shades.set(color, all);
  }
  const step = Math.round(light * STEPS);
  return (all[step] ??= dimmed(color, step / STEPS));
}

function dimmed(color: string, light: number): string {
  const channels = channelsOf(color).map((channel) => Math.round(channel * light));
  return `#${channels.map((channel) => channel.toString(16).padStart(2, '0')).join('')}`;
}
