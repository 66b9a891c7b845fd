package rsal.jadex.hunt.mind;

import java.util.List;

/// What a hunter's mind can have done, on whichever thread it thinks: all return at once, and are done in that order.
public interface Hunting {
    /// The mind is there.
    void begun(Thinking mind);

    /// Stands and waits for word of a prey.
    void lookOut();

    /// Goes for where the prey was last.
    ///
    /// @param over told on any thread once it is worth to look where the prey is now
    void approach(Runnable over);

    /// Its mind can't go on.
    void failed(Throwable fault);

    /// What it wants now, for people.
    void wants(List<Desire> desires);

    /// @see jadex.bdiv3.runtime.IGoal
    final class Desire {
        private final String name;
        private final String state;
        private final String plan;

        /// @param state as Jadex calls it: `ACTIVE`, `SUSPENDED`, …
        /// @param plan that is meant for it, by name
        Desire(String name, String state, String plan) {
            this.name = name;
            this.state = state;
            this.plan = plan;
        }

        public String name() {
            return name;
        }

        public String state() {
            return state;
        }

        public String plan() {
            return plan;
        }
    }
}
