/**
 * Very many small squares, set straight into an image: as shapes, a hundred thousand of them would take longer to draw
 * than a frame is shown. Where they lie upon each other they are stronger, and have the color of the last.
 */
export class Dots {
  private readonly canvas = document.createElement('canvas');
  private image = new ImageData(1, 1);
  private width = 1;
  private height = 1;
  private pixels = new Uint32Array(this.image.data.buffer);
  private matrix = [1, 0, 0, 1, 0, 0]; // from the map to the canvas' own pixels
  private side = 1;
  private strength = 255;
  private last = -1; // where the dot before this one is

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
      this.pixels = new Uint32Array(this.image.data.buffer);
    } else {
      this.pixels.fill(0);
    }
    const { a, b, c, d, e, f } = context.getTransform();
    this.matrix = [a, b, c, d, e, f]; // a DOMMatrix takes longer to read than a dot to set
    this.side = Math.max(1, Math.round(side * Math.hypot(a, b)));
    this.strength = Math.ceil(255 * strength);
    this.last = -1;
  }

  /**
   * Sets one, unless it is where the one before is.
   *
   * @param bgr as {@link bgrOf} gives it
   * @param share of the strength
   */
  set(x: number, y: number, bgr: number, share = 1) {
    const { pixels, side, width, height } = this;
    const [a, b, c, d, e, f] = this.matrix as [number, number, number, number, number, number];
    const left = Math.round(a * x + c * y + e - side / 2);
    const top = Math.round(b * x + d * y + f - side / 2);
    const place = top * width + left;
    if (place === this.last) {
      return;
    }
    this.last = place;
    const strength = this.strength * share;
    const right = Math.min(width, left + side);
    const bottom = Math.min(height, top + side);
    for (let row = Math.max(0, top); row < bottom; row++) {
      const begin = row * width;
      for (let at = begin + Math.max(0, left); at < begin + right; at++) {
        const before = pixels[at]! >>> 24;
        const alpha = before + Math.ceil(((255 - before) * strength) / 255);
        pixels[at] = ((alpha << 24) | bgr) >>> 0;
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
