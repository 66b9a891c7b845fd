const KEY = 'rsal.token';

/** Whether this tab may change anything, and by what token. */
class Access {
  token = $state<string | null>(null);
  /** Whether this tab looks back: what is over can't be changed. */
  past = $state(false);

  get allowed(): boolean {
    return this.operator && !this.past;
  }

  /** Whether it may once it looks at what is now. */
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

  /** The server does not know the token (any more). */
  drop() {
    sessionStorage.removeItem(KEY);
    this.token = null;
  }
}

export const access = new Access();
