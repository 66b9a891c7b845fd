import { access } from '../api/access.svelte';
import { api } from '../api/client';
import type { Control as Told } from '../api/messages';
import { live } from '../live/live.svelte';
import { notices } from '../notices.svelte';
import { texts } from '../texts';

/** Between an answer and the next question; the server's term is several times as long. */
const PAUSE_MILLIS = 2000;
const FIRST_PAUSE_MILLIS = 200;
const NAME = 'rsal.name';

/** Who alone may change anything for now, of all who have the token. */
class Control {
  /** Whoever has it; null when all who have the token may act. */
  holder = $state<string | null>(null);
  mine = $state(false);

  /** As this person was called last. */
  get name(): string {
    return localStorage.getItem(NAME) ?? '';
  }

  /** Asks, and keeps it while it is this tab's, from now on. */
  start() {
    void this.ask();
    addEventListener('pagehide', () => {
      if (this.mine && top === window) {
        void api.giveControlBack().catch(() => {});
      }
    });
  }

  private async ask() {
    const isKnown = live.info !== null; // and with it, whether this is a recording, which nobody controls
    if (isKnown && live.recording === null) {
      await this.keepOrLook();
    }
    setTimeout(() => void this.ask(), isKnown ? PAUSE_MILLIS : FIRST_PAUSE_MILLIS);
  }

  private async keepOrLook() {
    try {
      const kept = this.mine ? await api.takeControl({ name: this.name, over: false }) : await api.control();
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
    this.mine = false; // or it would be taken again meanwhile
    await api.giveControlBack();
    await this.look();
  }
}

export const control = new Control();
