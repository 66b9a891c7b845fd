import type { Layer } from '../scene';
import { drawGoal } from './goals';
import { drawRobot } from './robots';

/** What a person is about to ask for. */
export const drawDraft: Layer = (context, { info, draft, view, palette }) => {
  if (draft === null) {
    return;
  }
  const { color, footprint } = info.robots[draft.robot]!;
  context.globalAlpha = 0.6;
  if (draft.kind === 'goal') {
    drawGoal(context, draft.pose, color, view.scale);
  } else {
    drawRobot(context, draft.pose, footprint, color, view.scale, palette.halo);
  }
  context.globalAlpha = 1;
};
