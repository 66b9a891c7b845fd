import type { Pose } from '../live/frame';

/** What a person is about to ask for, drawn until they let go. */
export interface Draft {
  kind: 'place' | 'goal';
  robot: number;
  pose: Pose;
}
