import { wrap } from '../live/motion';

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

/** What part of the map is seen, and how it is turned. Immutable: moving makes a new one. */
export class View {
  private readonly cos: number;
  private readonly sin: number;

  /**
   * @param scale pixels per metre
   * @param originX where the map frame's origin is on the canvas [px]
   * @param originY likewise
   * @param turn how far the map is turned counter-clockwise [rad]; at 0, y is up
   */
  constructor(
    readonly scale: number,
    readonly originX: number,
    readonly originY: number,
    readonly turn = 0,
  ) {
    this.cos = Math.cos(turn);
    this.sin = Math.sin(turn);
  }

  /** Shows all of the bounds in the middle of a canvas. */
  static fit(bounds: Bounds, width: number, height: number, turn = 0, margin = 16): View {
    const one = new View(1, 0, 0, turn);
    const corners = [bounds.minX, bounds.maxX].flatMap((x) =>
      [bounds.minY, bounds.maxY].map((y) => one.toPixel({ x, y })),
    );
    const across = corners.map(({ px }) => px);
    const down = corners.map(({ py }) => py);
    const [left, right] = [Math.min(...across), Math.max(...across)];
    const [top, bottom] = [Math.min(...down), Math.max(...down)];
    const scale = limited(
      Math.min((width - 2 * margin) / (right - left), (height - 2 * margin) / (bottom - top)),
    );
    return new View(
      scale,
      width / 2 - (scale * (left + right)) / 2,
      height / 2 - (scale * (top + bottom)) / 2,
      turn,
    );
  }

  toPixel({ x, y }: Point): Pixel {
    return {
      px: this.originX + this.scale * (x * this.cos - y * this.sin),
      py: this.originY - this.scale * (x * this.sin + y * this.cos),
    };
  }

  toMap({ px, py }: Pixel): Point {
    const right = (px - this.originX) / this.scale;
    const up = (this.originY - py) / this.scale;
    return { x: right * this.cos + up * this.sin, y: up * this.cos - right * this.sin };
  }

  /** From here on, a context that was in canvas coordinates [px] is in those of the map. */
  enter(context: CanvasRenderingContext2D) {
    const [cos, sin] = [this.scale * this.cos, this.scale * this.sin];
    context.transform(cos, -sin, -sin, -cos, this.originX, this.originY);
  }

  /** The way back, for what stands upright and keeps its size. Between `save` and `restore`. */
  leave(context: CanvasRenderingContext2D) {
    const [cos, sin] = [this.cos / this.scale, this.sin / this.scale];
    const { x, y } = this.toMap({ px: 0, py: 0 });
    context.transform(cos, -sin, -sin, -cos, x, y);
  }

  panned(dx: number, dy: number): View {
    return new View(this.scale, this.originX + dx, this.originY + dy, this.turn);
  }

  /** Closer by a factor; what is under the pixel stays there. */
  zoomed(factor: number, at: Pixel): View {
    const scale = limited(this.scale * factor);
    const ratio = scale / this.scale;
    return new View(
      scale,
      at.px + (this.originX - at.px) * ratio,
      at.py + (this.originY - at.py) * ratio,
      this.turn,
    );
  }

  /** The map turned counter-clockwise [rad] around a pixel. */
  turned(by: number, at: Pixel): View {
    return new View(this.scale, 0, 0, wrap(this.turn + by)).holding(this.toMap(at), at);
  }

  centred(on: Point, width: number, height: number): View {
    return this.holding(on, { px: width / 2, py: height / 2 });
  }

  /** Moved, so that a place is at a pixel. */
  private holding(place: Point, at: Pixel): View {
    const { px, py } = this.toPixel(place);
    return this.panned(at.px - px, at.py - py);
  }
}

function limited(scale: number): number {
  return Math.min(GREATEST_SCALE, Math.max(LEAST_SCALE, scale));
}
