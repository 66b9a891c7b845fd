import type { CameraView, CarriedInfo, LinkInfo, MountInfo, RealDetails, RunInfo } from '../api/messages';
import type { Frame, MovedThing, Pose } from '../live/frame';
import type { Things } from '../live/things';
import type { Trails } from '../live/trails';
import type { Draft } from './draft';
import type { Uprights } from './layers/uprights';
import type { Palette } from './palette';
import type { Point, View } from './view';

/** From one place of the map to another. */
export interface Tape {
  from: Point;
  to: Point;
}

/** All that is drawn at one moment. */
export interface Scene {
  info: RunInfo;
  frame: Frame;
  /** Where robots are drawn, in the order of the run's robots. */
  poses: (Pose | null)[];
  /** Robots that nobody hears of. */
  faded: ReadonlySet<number>;
  /** What there is to say of robots that are real. */
  real: ReadonlyMap<number, RealDetails>;
  /** What their actuators have carried elsewhere, of those of which that is told. */
  carried: ReadonlyMap<number, readonly CarriedInfo[]>;
  things: Things;
  /** Things that are elsewhere than was told, by number. */
  moved: ReadonlyMap<number, MovedThing>;
  trails: Trails;
  /** Which robots hear each other, while that is shown. */
  links: readonly LinkInfo[];
  /** What the selected robot's cameras make out, while that is shown. */
  cameras: readonly CameraView[];
  /** Where the selected robot's devices are mounted, while that is shown. */
  mounts: readonly MountInfo[];
  view: View;
  /** How many pixels of a canvas a CSS pixel is wide. */
  density: number;
  palette: Palette;
  selected: number | null;
  selectedThing: number | null;
  /** What stands still and hides others, in an oblique view. */
  uprights: Uprights | null;
  draft: Draft | null;
  tape: Tape | null;
}

/** Draws one kind of thing. The context is in map coordinates (metres, y up), so a pixel is `1 / view.scale`. */
export type Layer = (context: CanvasRenderingContext2D, scene: Scene) => void;
