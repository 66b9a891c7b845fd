/** How often something is said at least [ms]: the server takes half a second of silence for a hand that is gone. */
const PERIOD = 100;

/**
 * Says something again and again until it is told to stop. One saying is under way at a time, so that the newest is
 * what is heard last; what is new is said as soon as the one before was heard.
 */
export class Repeater<T> {
  private timer: ReturnType<typeof setInterval> | undefined;
  private saying: Promise<void> | null = null;
  private said: T | null = null;
  private newest: T | null = null;

  /** @param say rejects when it is to be said no more */
  constructor(
    private readonly say: (what: T) => Promise<void>,
    private readonly onFailure: (reason: unknown) => void,
  ) {}

  tell(what: T) {
    this.newest = what;
    this.timer ??= setInterval(() => this.sayNewest(), PERIOD);
    this.sayNewest();
  }

  /** Resolves when what was under way was heard, or never will be. */
  async stop(): Promise<void> {
    clearInterval(this.timer);
    this.timer = undefined;
    this.newest = null;
    await this.saying;
  }

  private sayNewest() {
    if (this.saying === null && this.newest !== null) {
      this.said = this.newest;
      this.saying = this.say(this.said)
        .catch((reason: unknown) => {
          if (this.timer !== undefined) {
            void this.stop();
            this.onFailure(reason);
          }
        })
        .finally(() => {
          this.saying = null;
          if (this.newest !== this.said) {
            this.sayNewest();
          }
        });
    }
  }
}
