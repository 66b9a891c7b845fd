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

/** What notices are about that tell who has control. */
export const ABOUT_CONTROL = 'control';

/** Who alone may change anything for now, of all who have the token. */
class Control {
  /** Whoever has it; null when all who have the token may act. */
  holder = $state<string | null>(null);
  mine = $state(false);
  /** How often it was taken or given back here: answers to what was asked before that come late. */
  private changes = 0;
  private asking: Promise<void> = Promise.resolve();

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
      this.asking = this.keepOrLook();
      await this.asking;
    }
    setTimeout(() => void this.ask(possible), possible() === null ? FIRST_PAUSE_MILLIS : PAUSE_MILLIS);
  }

  private async keepOrLook() {
    const asked = this.changes;
    try {
      const mine = !framed && (this.mine || (this.had && this.holder === null)); // else the page around keeps it
      const kept = mine ? await api.takeControl({ name: this.name, over: false }) : await api.control();
      if (kept !== null && asked === this.changes) {
        this.learn(kept);
      }
    } catch {
      await this.look(); // somebody has taken it over, or the server is gone
    }
  }

  private async look() {
    const asked = this.changes;
    const told = await api.control();
    if (told !== null && asked === this.changes) {
      this.learn(told);
    }
  }

  private learn({ holder, mine }: Told) {
    if (this.holder !== holder || this.mine !== mine) {
      notices.dismissAbout(ABOUT_CONTROL);
    }
    if (this.mine && !mine && holder !== null) {
      notices.add(texts.control.lost(holder), false, ABOUT_CONTROL);
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
    const taken = await api.takeControl({ name, over: true });
    this.changes++;
    this.learn(taken);
  }

  async giveBack() {
    sessionStorage.removeItem(HAD);
    this.mine = false;
    this.changes++;
    await this.asking; // which may have taken it once more
    await api.giveControlBack();
    this.changes++;
    await this.look();
  }
}

export const control = new Control();
