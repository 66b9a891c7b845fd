/** What this viewer looks at; nobody else sees it. */
class Selection {
  /** Index of a robot of the run. */
  robot = $state<number | null>(null);
  following = $state(false);
  /** The next click on the map sends the selected robot there. */
  aiming = $state(false);

  select(robot: number | null) {
    this.robot = robot;
    this.following = this.following && robot !== null;
    this.aiming = false;
  }

  toggleFollowing() {
    this.following = this.robot !== null && !this.following;
  }

  letGo() {
    if (this.aiming) {
      this.aiming = false;
    } else if (this.following) {
      this.following = false;
    } else {
      this.robot = null;
    }
  }
}

export const selection = new Selection();
