/** Colors of the map, from the style sheet, so that light and dark are decided in one place. */
export interface Palette {
  free: string;
  occupied: string;
  unknown: string;
  /** Of maps that robots draw. */
  drawn: string;
  drawnWall: string;
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
    unknown: color('unknown'),
    drawn: color('drawn'),
    drawnWall: color('drawn-wall'),
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
