import type { RobotInfo } from '../../api/messages';
import type { Palette } from '../palette';
import type { Context } from '../context';
import { View } from '../view';

/** Of more robots than this, what is drawn again and again is copied from pictures. */
export const MANY = 60;

const HEADINGS = 128;
const TURN = 2 * Math.PI;

/** Draws a robot at a pose, in map coordinates. */
type Draw = (context: Context, heading: number, view: View) => void;

/**
 * Small robots as pictures, one of each look and heading: where they are many, copying takes a tenth of drawing. They
 * stand at whole pixels and look into one of 128 directions.
 */
export class Sprites {
  private readonly made = new Map<string, ImageBitmap[]>();
  private readonly looks = new WeakMap<RobotInfo, string>();
  private view = new View(1, 0, 0);
  private palette: Palette | null = null;
  private density = 1;

  /**
   * What follows is seen so. Pictures for another view are forgotten; none are worth making while each is looked at
   * once, as when the map is zoomed.
   *
   * @returns whether it is seen as it was before, so that pictures pay
   */
  begin(view: View, density: number, palette: Palette): boolean {
    const same =
      view.scale === this.view.scale &&
      view.turn === this.view.turn &&
      view.oblique === this.view.oblique &&
      palette === this.palette &&
      density === this.density;
    if (!same) {
      this.forget();
    }
    this.view = view;
    this.palette = palette;
    this.density = density;
    return same;
  }

  private forget() {
    this.made.forEach((headings) => headings.forEach((picture) => picture.close()));
    this.made.clear();
  }

  /**
   * A picture with the robot in its middle.
   *
   * @param reach how far from its middle anything of it is drawn [px]
   */
  of(robot: RobotInfo, heading: number, reach: number, draw: Draw): ImageBitmap {
    let look = this.looks.get(robot);
    if (look === undefined) {
      look = JSON.stringify([robot.footprint, robot.pieces, robot.color]);
      this.looks.set(robot, look);
    }
    const headings = this.made.get(look) ?? [];
    this.made.set(look, headings);
    const direction = ((Math.round((heading / TURN) * HEADINGS) % HEADINGS) + HEADINGS) % HEADINGS;
    return (headings[direction] ??= this.make((direction / HEADINGS) * TURN, reach, draw));
  }

  private make(heading: number, reach: number, draw: Draw): ImageBitmap {
    const { scale, turn, oblique } = this.view;
    const half = Math.ceil(reach * this.density);
    return pictureOf(2 * half, 2 * half, this.density, (context) => {
      const view = new View(scale, half / this.density, half / this.density, { turn, oblique });
      view.enter(context);
      draw(context, heading, view);
    });
  }
}

/**
 * Draws once what is to be copied.
 *
 * @param width and height in the picture's own pixels, of which a CSS pixel is `density`
 * @param draw in CSS pixels
 */
export function pictureOf(
  width: number,
  height: number,
  density: number,
  draw: (context: Context) => void,
): ImageBitmap {
  const canvas = new OffscreenCanvas(width, height);
  const context = canvas.getContext('2d')!;
  context.scale(density, density);
  draw(context);
  return canvas.transferToImageBitmap();
}
