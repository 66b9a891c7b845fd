const KEY = 'rsal.token';
const OPERATOR = 'rsal.operator';

/** Whether this tab may change anything, and by what token. */
class Access {
  token = $state<string | null>(null);
  /** Whether this tab looks back: what is over can't be changed. */
  past = $state(false);
  /** Who else has control, so that this tab may only stop in an emergency. */
  elsewhere = $state<string | null>(null);

  /** By what the server tells this tab from others. Frames in it are of the same. */
  get id(): string {
    return sessionStorage.getItem(OPERATOR) ?? this.newId();
  }

  private newId(): string {
    const id = crypto.randomUUID();
    sessionStorage.setItem(OPERATOR, id);
    return id;
  }

  /**
   * A tab that was duplicated has all that the first one keeps, its id, too. It asks whether another one has that, and
   * is somebody else then. Not for frames, which are in the same tab.
   *
   * @param becomesOther called when it is
   */
  tellFromOtherTabs(becomesOther: () => void) {
    const tabs = new BroadcastChannel('rsal.tabs');
    tabs.onmessage = ({ data }: MessageEvent<{ asks?: string; has?: string }>) => {
      if (data.asks === this.id) {
        tabs.postMessage({ has: this.id });
      } else if (data.has === this.id) {
        this.newId();
        becomesOther();
      }
    };
    tabs.postMessage({ asks: this.id });
  }

  get allowed(): boolean {
    return this.mayArm && !this.past;
  }

  /** Whether it may arm motors, which are those of the present wherever it looks. */
  get mayArm(): boolean {
    return this.operator && this.elsewhere === null;
  }

  /** Whether it has the token. */
  get operator(): boolean {
    return this.token !== null;
  }

  /**
   * Takes the token out of the address bar, where it could be copied along with the address, and keeps it for this tab.
   *
   * @returns whether the address asks to begin with the choice of a scenario
   */
  takeToken(): boolean {
    const asked = new URLSearchParams(location.hash.slice(1));
    const given = asked.get('token');
    if (given !== null) {
      sessionStorage.setItem(KEY, given);
      history.replaceState(null, '', location.pathname + location.search);
    }
    this.token = sessionStorage.getItem(KEY);
    return asked.has('choose');
  }

  /** The token, before it is taken out of the address bar. */
  get given(): string | null {
    return new URLSearchParams(location.hash.slice(1)).get('token') ?? sessionStorage.getItem(KEY);
  }

  /** Keeps a token that a person typed, for this tab. */
  keep(token: string) {
    sessionStorage.setItem(KEY, token);
  }

  /** The server does not know the token (any more). */
  drop() {
    sessionStorage.removeItem(KEY);
    this.token = null;
  }
}

export const access = new Access();
