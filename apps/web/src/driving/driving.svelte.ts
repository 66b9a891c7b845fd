import { api, RefusedError } from '../api/client';
import type { Abilities, RobotDetails } from '../api/messages';
import { live } from '../live/live.svelte';
import { notices } from '../notices.svelte';
import { Repeater } from './repeater';
import { REST, steers, velocityOf, wishOf, type Velocity, type Wish } from './wish';

/** What this page calls itself when it drives. It tells pages apart and is no secret: all that watch see it. */
const me = Array.from(crypto.getRandomValues(new Uint8Array(12)), (byte) =>
  byte.toString(16).padStart(2, '0'),
).join('');

/** Driving a robot by hand: keys or the pad. Whether it does is what the server says. */
class Driving {
  /** Id of the robot that this page drives, or has asked for. */
  robot = $state<string | null>(null);
  can = $state.raw<Abilities | null>(null);
  /** Of the full speed [%]. */
  speed = $state(50);
  pad = $state.raw<Wish>(REST);

  private pressed = new Set<string>();
  private shift = false;
  private confirmed = false;
  private readonly repeater = new Repeater<{ robot: string } & Velocity>(
    async (wish) => {
      await api.tell('drive', { ...wish, driver: me });
    },
    (reason) => {
      this.forget();
      if (!(reason instanceof RefusedError)) {
        throw reason;
      }
      notices.add(reason.message);
    },
  );

  isMe(driver: string): boolean {
    return driver === me;
  }

  take(robot: string, can: Abilities) {
    void this.letGo();
    this.releaseAll();
    this.robot = robot;
    this.can = can;
    this.confirmed = false;
    this.tell();
  }

  /** Resolves when the robot was given back. */
  async letGo(): Promise<void> {
    const { robot } = this;
    if (robot !== null) {
      this.forget();
      await this.repeater.stop();
      await api.tell('release', { robot, driver: me }).catch(() => {}); // then it is given back when nobody is heard
    }
  }

  /** At the very end of the page. */
  leave() {
    if (this.robot !== null) {
      void api.tell('release', { robot: this.robot, driver: me });
      this.forget();
      void this.repeater.stop();
    }
  }

  private forget() {
    this.robot = null;
    this.releaseAll();
  }

  /** No key or finger counts any more, before it was lifted and put down again. */
  releaseAll() {
    this.pressed.clear();
    this.shift = false;
    this.pad = REST;
    this.tell();
  }

  /** @returns whether the key was for driving */
  keyDown(event: KeyboardEvent): boolean {
    if (this.robot === null) {
      return false;
    }
    this.shift = event.shiftKey;
    const driven = steers(event.code);
    if (driven && !event.repeat) {
      this.pressed.add(event.code);
    }
    this.tell();
    return driven;
  }

  keyUp(event: KeyboardEvent) {
    if (this.robot !== null) {
      this.shift = event.shiftKey;
      this.pressed.delete(event.code);
      this.tell();
    }
  }

  /** What the pad says; nothing when that has outlived its robot. */
  hold(wish: Wish) {
    if (this.robot !== null) {
      this.pad = wish;
      this.tell();
    }
  }

  /** @param percent of the full speed, from now on */
  share(percent: number) {
    this.speed = percent;
    this.tell();
  }

  /** What the server says about the robots. */
  look(robots: RobotDetails[]) {
    const driver = robots.find(({ id }) => id === this.robot)?.driver;
    if (this.robot === null || driver === undefined) {
      return;
    }
    if (driver === me) {
      this.confirmed = true;
    } else if (this.confirmed) {
      this.forget(); // it was given back, since this page was not heard for long
      void this.repeater.stop();
    }
  }

  private tell() {
    if (this.robot !== null && this.can !== null && !live.over) {
      const wish = this.pad === REST ? wishOf(this.pressed) : this.pad;
      this.repeater.tell({
        robot: this.robot,
        ...velocityOf(wish, this.can, this.shift ? 1 : this.speed / 100),
      });
    }
  }
}

export const driving = new Driving();
