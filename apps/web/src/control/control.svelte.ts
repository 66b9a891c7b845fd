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
  /** Whether it is being taken or given back here: nothing is asked meanwhile, as the answer might be of before. */
  private changing = false;
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
    if (!framed) {
      access.tellFromOtherTabs(() => {
        sessionStorage.removeItem(HAD);
        this.mine = false;
      });
    }
    void this.ask(possible);
    addEventListener('pagehide', () => {
      if (this.mine && !framed) {
        void api.giveControlBack().catch(() => {});
      }
    });
  }

  private async ask(possible: () => boolean | null) {
    if (possible() && !this.changing) {
      this.asking = this.keepOrLook();
      await this.asking;
    }
    setTimeout(() => void this.ask(possible), possible() === null ? FIRST_PAUSE_MILLIS : PAUSE_MILLIS);
  }

  private async keepOrLook() {
    try {
      this.learn(await this.next());
    } catch {
      this.learn(await api.control()); // somebody has taken it over, or the server is gone
    }
  }

  /** Not taken anew where it is had: what this page says at last, as it is left, may come before. */
  private next(): Promise<Told | null> {
    if (framed) {
      return api.control(); // the page around keeps it
    }
    if (this.mine) {
      return api.keepControl();
    }
    return this.had && this.holder === null
      ? api.takeControl({ name: this.name, over: false })
      : api.control();
  }

  /** @param told null where the server told nothing */
  private learn(told: Told | null) {
    if (told === null) {
      return;
    }
    const { holder, mine } = told;
    if (this.holder !== holder || this.mine !== mine) {
      notices.dismissAbout(ABOUT_CONTROL);
    }
    if (this.mine && !mine && holder !== null) {
      notices.add(texts.control.lost(holder), false, ABOUT_CONTROL);
    }
    this.holder = holder;
    this.mine = mine;
    if (!framed) {
      this.remember(mine, holder); // frames are in the same tab, and may be told late what was so before
    }
    access.elsewhere = mine ? null : holder;
  }

  private remember(mine: boolean, holder: string | null) {
    if (mine) {
      sessionStorage.setItem(HAD, 'true');
    } else if (holder !== null) {
      sessionStorage.removeItem(HAD);
    }
  }

  /**
   * @param name of whoever takes it
   * @throws RefusedError when the server won't
   */
  async take(name: string) {
    localStorage.setItem(NAME, name);
    await this.change(async () => this.learn(await api.takeControl({ name, over: true })));
  }

  async giveBack() {
    sessionStorage.removeItem(HAD); // also for whoever leaves the page before there is an answer
    await this.change(async () => {
      sessionStorage.removeItem(HAD); // what was asked before may have told that it is had
      this.learn(await api.giveControlBack());
    });
  }

  private async change(change: () => Promise<void>) {
    this.changing = true;
    try {
      await this.asking;
      await change();
    } finally {
      this.changing = false;
    }
  }
}

export const control = new Control();
