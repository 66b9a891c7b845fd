/** A place in the map frame [m], x right, y up. */
export interface Point {
  x: number;
  y: number;
}

/** A place on the canvas [CSS pixels], x right, y down. */
export interface Pixel {
  px: number;
  py: number;
}

export interface Bounds {
  minX: number;
  minY: number;
  maxX: number;
  maxY: number;
}

const LEAST_SCALE = 1;
const GREATEST_SCALE = 800;

/** What part of the map is seen. Immutable: moving makes a new one. */
export class View {
  /**
   * @param scale pixels per metre
   * @param originX where the map frame's origin is on the canvas [px]
   * @param originY likewise
   */
  constructor(
    readonly scale: number,
    readonly originX: number,
    readonly originY: number,
  ) {}

  /** Shows all of the bounds in the middle of a canvas. */
  static fit(bounds: Bounds, width: number, height: number, margin = 16): View {
    const scale = limited(
      Math.min(
        (width - 2 * margin) / (bounds.maxX - bounds.minX),
        (height - 2 * margin) / (bounds.maxY - bounds.minY),
      ),
    );
    return new View(scale, 0, 0).centred(
      { x: (bounds.minX + bounds.maxX) / 2, y: (bounds.minY + bounds.maxY) / 2 },
      width,
      height,
    );
  }

  toPixel({ x, y }: Point): Pixel {
    return { px: this.originX + x * this.scale, py: this.originY - y * this.scale };
  }

  toMap({ px, py }: Pixel): Point {
    return { x: (px - this.originX) / this.scale, y: (this.originY - py) / this.scale };
  }

  panned(dx: number, dy: number): View {
    return new View(this.scale, this.originX + dx, this.originY + dy);
  }

  /** Closer by a factor; what is under the pixel stays there. */
  zoomed(factor: number, at: Pixel): View {
    const scale = limited(this.scale * factor);
    const ratio = scale / this.scale;
    return new View(scale, at.px + (this.originX - at.px) * ratio, at.py + (this.originY - at.py) * ratio);
  }

  centred(on: Point, width: number, height: number): View {
    return new View(this.scale, width / 2 - on.x * this.scale, height / 2 + on.y * this.scale);
  }
}

function limited(scale: number): number {
  return Math.min(GREATEST_SCALE, Math.max(LEAST_SCALE, scale));
}
