import { untrack } from 'svelte';
import { RefusedError } from './api/client';

const SHOWN_MILLIS = 8000;

/** Refusals and failures, each shown for a while. */
class Notices {
  list = $state<{ id: number; text: string; about: string | null }[]>([]);
  private next = 1;

  /**
   * @param lasting until somebody puts it away
   * @param about what it tells of: to be put away when that has changed
   */
  add(text: string, lasting = false, about: string | null = null) {
    const id = this.next++;
    const others = untrack(() => this.list).filter((notice) => notice.text !== text); // effects add some, too
    this.list = [...others, { id, text, about }];
    if (!lasting) {
      setTimeout(() => this.dismiss(id), SHOWN_MILLIS);
    }
  }

  /** What is told of it is true no more. */
  dismissAbout(what: string) {
    this.list = untrack(() => this.list).filter(({ about }) => about !== what);
  }

  dismiss(id: number) {
    this.list = untrack(() => this.list).filter((notice) => notice.id !== id);
  }
}

export const notices = new Notices();

/**
 * Waits for a command; when it is refused, says why.
 *
 * @param lasting whether it says so until somebody puts that away
 * @returns whether it was done
 */
export async function attempt(command: Promise<unknown>, lasting = false): Promise<boolean> {
  try {
    await command;
    return true;
  } catch (e) {
    if (!(e instanceof RefusedError)) {
      throw e;
    }
    notices.add(e.message, lasting);
    return false;
  }
}
