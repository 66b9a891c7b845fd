/**
 * Very many small squares, set straight into an image: as shapes, a hundred thousand of them would take longer to draw
 * than a frame is shown. Where they lie upon each other they are stronger, and have the color of the last.
 */
export class Dots {
  private readonly canvas = document.createElement('canvas');
  private image = new ImageData(1, 1);
  private width = 1;
  private height = 1;
  private pixels = new Int32Array(this.image.data.buffer); // set twice as fast as unsigned ones
  /** From the map to the canvas' own pixels, as columns of a matrix; the last is that of a dot's corner. */
  private xx = 1;
  private xy = 0;
  private yx = 0;
  private yy = 1;
  private atX = 0;
  private atY = 0;
  private side = 1;
  private strength = 255;
  private lastLeft = NaN; // where the dot before this one is
  private lastTop = NaN;

  /**
   * Begins anew.
   *
   * @param context in map coordinates
   * @param side [m]
   * @param strength of one dot, 0 to 1
   */
  begin(context: CanvasRenderingContext2D, side: number, strength: number) {
    const { width, height } = context.canvas;
    if (this.width !== width || this.height !== height) {
      this.width = this.canvas.width = width;
      this.height = this.canvas.height = height;
      this.image = new ImageData(width, height);
      this.pixels = new Int32Array(this.image.data.buffer);
    } else {
      this.pixels.fill(0);
    }
    const { a, b, c, d, e, f } = context.getTransform(); // a DOMMatrix takes longer to read than a dot to set
    this.side = Math.max(1, Math.round(side * Math.hypot(a, b)));
    [this.xx, this.xy, this.yx, this.yy] = [a, b, c, d];
    [this.atX, this.atY] = [e - this.side / 2, f - this.side / 2];
    this.strength = Math.ceil(255 * strength);
    this.lastLeft = this.lastTop = NaN;
  }

  /**
   * Sets one, unless it is where the one before is.
   *
   * @param bgr as {@link bgrOf} gives it
   * @param share of the strength
   */
  set(x: number, y: number, bgr: number, share = 1) {
    const { pixels, side, width, height } = this;
    const left = Math.floor(this.xx * x + this.yx * y + this.atX + 0.5);
    const top = Math.floor(this.xy * x + this.yy * y + this.atY + 0.5);
    if (left === this.lastLeft && top === this.lastTop) {
      return;
    }
    this.lastLeft = left;
    this.lastTop = top;
    const strength = Math.round(this.strength * share * 257); // of 65535
    const right = Math.min(width, left + side);
    const bottom = Math.min(height, top + side);
    for (let row = Math.max(0, top); row < bottom; row++) {
      const begin = row * width;
      const end = begin + right;
      for (let at = begin + Math.max(0, left); at < end; at++) {
        const before = pixels[at]! >>> 24;
        const alpha = before + (((255 - before) * strength + 65535) >>> 16); // rounded up
        pixels[at] = (alpha << 24) | bgr;
      }
    }
  }

  /** Draws them where they were set. */
  draw(context: CanvasRenderingContext2D) {
    this.canvas.getContext('2d')!.putImageData(this.image, 0, 0);
    context.save();
    context.resetTransform();
    context.drawImage(this.canvas, 0, 0);
    context.restore();
  }
}

/** Blue, green and red, a byte each, of `#rrggbb`. */
export function bgrOf(color: string): number {
  const rgb = parseInt(color.slice(1), 16);
  return ((rgb & 0xff) << 16) | (rgb & 0xff00) | (rgb >>> 16);
}
