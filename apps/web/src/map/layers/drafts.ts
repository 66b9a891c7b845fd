import type { Layer } from '../scene';
import { drawGoal } from './goals';
import { drawRobot } from './robots';
import { drawThing } from './things';

/** What a person is about to ask for. */
export const drawDraft: Layer = (context, { info, frame, carried, things, draft, view, palette }) => {
  if (draft === null) {
    return;
  }
  const { target, pose } = draft;
  context.globalAlpha = 0.6;
  if (target.thing !== undefined) {
    const thing = things.all.get(target.thing);
    if (thing) {
      drawThing(context, { ...thing, pose }, view, palette);
    }
  } else if (draft.kind === 'goal') {
    drawGoal(context, pose, info.robots[target.robot]!.color, view.scale);
  } else {
    const i = target.robot;
    drawRobot(context, pose, info.robots[i]!, view, palette, frame.robots[i], carried.get(i));
  }
  context.globalAlpha = 1;
};
