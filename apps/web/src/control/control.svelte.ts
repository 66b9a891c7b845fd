import { access } from '../api/access.svelte';
import { api } from '../api/client';
import type { Control as Told } from '../api/messages';
import { framed } from '../framed';
import { notices } from '../notices.svelte';
import { texts } from '../texts';

/** Between an answer and the next question; the server's term is several times as long. */
const PAUSE_MILLIS = 2000;
const FIRST_PAUSE_MILLIS = 200;
const NAME = 'rsal.name';
const HAD = 'rsal.control';

/** Who alone may change anything for now, of all who have the token. */
class Control {
  /** Whoever has it; null when all who have the token may act. */
  holder = $state<string | null>(null);
  mine = $state(false);

  /** Whether this tab had it on the page before, which gave it back as it was left. */
  private get had(): boolean {
    return sessionStorage.getItem(HAD) !== null;
  }

  /** As this person was called last. */
  get name(): string {
    return localStorage.getItem(NAME) ?? '';
  }

  /**
   * Asks, and keeps it while it is this tab's, from now on.
   *
   * @param possible whether there is something to control; null while that is not known
   */
  start(possible: () => boolean | null) {
    void this.ask(possible);
    addEventListener('pagehide', () => {
      if (this.mine && !framed) {
        void api.giveControlBack().catch(() => {});
      }
    });
  }

  private async ask(possible: () => boolean | null) {
    if (possible()) {
      await this.keepOrLook();
    }
    setTimeout(() => void this.ask(possible), possible() === null ? FIRST_PAUSE_MILLIS : PAUSE_MILLIS);
  }

  private async keepOrLook() {
    try {
      const mine = !framed && (this.mine || (this.had && this.holder === null)); // else the page around keeps it
      const kept = mine ? await api.takeControl({ name: this.name, over: false }) : await api.control();
      if (kept !== null) {
        this.learn(kept);
      }
    } catch {
      await this.look(); // somebody has taken it over, or the server is gone
    }
  }

  private async look() {
    const told = await api.control();
    if (told !== null) {
      this.learn(told);
    }
  }

  private learn({ holder, mine }: Told) {
    if (this.mine && !mine && holder !== null) {
      notices.add(texts.control.lost(holder));
    }
    this.holder = holder;
    this.mine = mine;
    if (mine) {
      sessionStorage.setItem(HAD, 'true');
    } else if (holder !== null) {
      sessionStorage.removeItem(HAD);
    }
    access.elsewhere = mine ? null : holder;
  }

  /**
   * @param name of whoever takes it
   * @throws RefusedError when the server won't
   */
  async take(name: string) {
    localStorage.setItem(NAME, name);
    this.learn(await api.takeControl({ name, over: true }));
  }

  async giveBack() {
    sessionStorage.removeItem(HAD);
    this.mine = false; // or it would be taken again meanwhile
    await api.giveControlBack();
    await this.look();
  }
}

export const control = new Control();
