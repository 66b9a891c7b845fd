import { texts } from '../texts';
import { access } from './access.svelte';

/**
 * Shows the token to a server of another machine, which then gives this browser a cookie: it lets nobody watch without a
 * token, and a browser can't send one along with pictures and WebSockets. On this machine all may watch.
 *
 * @returns why the page can't be shown; null when it can
 */
export async function enter(): Promise<string | null> {
  try {
    if (access.given !== null) {
      await fetch('api/session', { method: 'POST', headers: { Authorization: `Bearer ${access.given}` } });
    }
    const answer = await fetch('api/run');
    return answer.status === 401 ? texts.refused.needsToken : null;
  } catch {
    return texts.refused.noAnswer;
  }
}
