import type { Pose } from '../live/frame';

/** What a person takes hold of: a robot by its index, a thing by its number. */
export type Target = { robot: number; thing?: never } | { robot?: never; thing: number };

/** What a person is about to ask for, drawn until they let go. */
export interface Draft {
  kind: 'place' | 'goal';
  target: Target;
  pose: Pose;
}
