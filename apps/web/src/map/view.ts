import type { Pose } from '../live/frame';
import type { Context } from './context';
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

/** How steeply an oblique view looks down [rad]. */
const ELEVATION = (52 * Math.PI) / 180;

/** How the map is looked at. */
export interface Posture {
  /** How far the map is turned counter-clockwise [rad]; at 0, y is up. */
  turn: number;
  /** Whether it is seen at an angle, by parallel lines: what is behind is no smaller, and heights are seen. */
  oblique: boolean;
}

const UPRIGHT: Posture = { turn: 0, oblique: false };

/** What part of the map is seen, and how. Immutable: moving makes a new one. */
export class View {
  readonly turn: number;
  readonly oblique: boolean;
  /** How long what leads away from who looks is drawn, of its length. */
  readonly squeeze: number;
  /** How long what stands upright is drawn, of its length. */
  readonly rise: number;
  /** Where a metre of height is drawn on the floor: what stands there hides as much. Zero as seen from above. */
  readonly up: Point;
  private readonly cos: number;
  private readonly sin: number;

  /**
   * @param scale pixels per metre
   * @param originX where the map frame's origin is on the canvas [px]
   * @param originY likewise
   */
  constructor(
    readonly scale: number,
    readonly originX: number,
    readonly originY: number,
    { turn, oblique } = UPRIGHT,
  ) {
    this.turn = turn;
    this.oblique = oblique;
    this.cos = Math.cos(turn);
    this.sin = Math.sin(turn);
    this.squeeze = oblique ? Math.sin(ELEVATION) : 1;
    this.rise = oblique ? Math.cos(ELEVATION) : 0;
    const steep = this.rise / this.squeeze;
    this.up = { x: steep * this.sin, y: steep * this.cos };
  }

  /**
   * Shows all of the bounds in the middle of a canvas.
   *
   * @param top how high what stands there is [m]
   */
  static fit(bounds: Bounds, width: number, height: number, posture = UPRIGHT, top = 0, margin = 16): View {
    const one = new View(1, 0, 0, posture);
    const corners = [bounds.minX, bounds.maxX].flatMap((x) =>
      [bounds.minY, bounds.maxY].map((y) => one.toPixel({ x, y })),
    );
    const across = corners.map(({ px }) => px);
    const down = corners.map(({ py }) => py);
    const [left, right] = [Math.min(...across), Math.max(...across)];
    const [upper, lower] = [Math.min(...down) - top * one.rise, Math.max(...down)];
    const scale = limited(
      Math.min((width - 2 * margin) / (right - left), (height - 2 * margin) / (lower - upper)),
    );
    return new View(
      scale,
      width / 2 - (scale * (left + right)) / 2,
      height / 2 - (scale * (upper + lower)) / 2,
      posture,
    );
  }

  /** @param z above the floor [m] */
  toPixel({ x, y }: Point, z = 0): Pixel {
    const away = this.squeeze * (x * this.sin + y * this.cos) + this.rise * z;
    return {
      px: this.originX + this.scale * (x * this.cos - y * this.sin),
      py: this.originY - this.scale * away,
    };
  }

  /** @param z of the plane that the place is in, above the floor [m] */
  toMap({ px, py }: Pixel, z = 0): Point {
    const right = (px - this.originX) / this.scale;
    const away = (this.originY - py) / (this.scale * this.squeeze);
    return {
      x: right * this.cos + away * this.sin - z * this.up.x,
      y: away * this.cos - right * this.sin - z * this.up.y,
    };
  }

  /** Where something that is lifted from a pose is drawn, as a pose on the floor. */
  raised({ x, y, heading }: Pose, z: number): Pose {
    return { x: x + z * this.up.x, y: y + z * this.up.y, heading };
  }

  /** From here on, a context that was in canvas coordinates [px] is in those of the map. */
  enter(context: Context) {
    const [cos, sin] = [this.scale * this.cos, this.scale * this.sin];
    context.transform(cos, -this.squeeze * sin, -sin, -this.squeeze * cos, this.originX, this.originY);
  }

  /** The way back, for what stands upright and keeps its size. Between `save` and `restore`. */
  leave(context: Context) {
    const [cos, sin] = [this.cos / this.scale, this.sin / this.scale];
    const { x, y } = this.toMap({ px: 0, py: 0 });
    context.transform(cos, -sin, -sin / this.squeeze, -cos / this.squeeze, x, y);
  }

  /** Itself when nobody would see it. */
  panned(dx: number, dy: number): View {
    if (Math.abs(dx) < 0.01 && Math.abs(dy) < 0.01) {
      return this;
    }
    return new View(this.scale, this.originX + dx, this.originY + dy, this);
  }

  /** Closer by a factor; what is under the pixel stays there. */
  zoomed(factor: number, at: Pixel): View {
    const scale = limited(this.scale * factor);
    const ratio = scale / this.scale;
    return new View(
      scale,
      at.px + (this.originX - at.px) * ratio,
      at.py + (this.originY - at.py) * ratio,
      this,
    );
  }

  /** The map turned counter-clockwise [rad] around a pixel. */
  turned(by: number, at: Pixel): View {
    return this.as({ turn: wrap(this.turn + by), oblique: this.oblique }, at);
  }

  /** Looked at as it is to be; what is under the pixel stays there. */
  as(posture: Posture, at: Pixel): View {
    return new View(this.scale, 0, 0, posture).holding(this.toMap(at), at);
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
