import type { MotorsOff } from '../api/messages';
import { texts } from '../texts';

/**
 * Says whose motors are off, and what arming them all at once is called: that ends an emergency stop, and leaves those
 * off that somebody switched off one by one.
 *
 * @returns null when all are on
 */
export function motorsOff({ all, of, switchedOff }: MotorsOff): { words: string; arm: string | null } | null {
  const stay = switchedOff.length > 0 ? ` ${texts.run.stayOff(switchedOff)}` : '';
  if (all) {
    return { words: texts.run.stopped + stay, arm: texts.run.rearm };
  }
  const others = of.filter((robot) => !switchedOff.includes(robot));
  if (others.length > 0) {
    return {
      words: texts.run.someStopped(others) + stay,
      arm: stay === '' ? texts.run.rearmAll : texts.run.rearmOthers,
    };
  }
  return of.length > 0 ? { words: texts.run.switchedOff(of), arm: null } : null;
}
