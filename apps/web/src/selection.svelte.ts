/** What this viewer looks at; nobody else sees it. */
class Selection {
  /** Index of a robot of the run. */
  robot = $state<number | null>(null);
  /** Number of a thing; never while a robot is selected. */
  thing = $state<number | null>(null);
  /** Name of the agent that is looked into; that of the selected robot at first. */
  agent = $state<string | null>(null);
  /** Name of something that will be there soon, to be selected then. */
  wanted = $state<string | null>(null);
  following = $state(false);
  /** What the selected robot would see is shown. */
  onboard = $state(false);
  /** The next click on the map sends the selected robot there. */
  aiming = $state(false);
  /** The map has the room of all panels. */
  mapAlone = $state(false);
  /** Dragging on the map measures distances. */
  measuring = $state(false);

  select(robot: number | null) {
    this.robot = robot;
    this.thing = null;
    this.wanted = null;
    this.following = this.following && robot !== null;
    this.aiming = false;
  }

  selectThing(thing: number | null) {
    this.select(null);
    this.thing = thing;
  }

  toggleFollowing() {
    this.following = this.robot !== null && !this.following;
  }

  letGo() {
    if (this.measuring) {
      this.measuring = false;
    } else if (this.aiming) {
      this.aiming = false;
    } else if (this.mapAlone) {
      this.mapAlone = false;
    } else if (this.following) {
      this.following = false;
    } else {
      this.select(null);
    }
  }
}

export const selection = new Selection();
