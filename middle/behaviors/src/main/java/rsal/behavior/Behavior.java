package rsal.behavior;

import rsal.data.Twist2d;

/// One layer of a subsumption stack. May keep a state; belongs to one stack then.
@FunctionalInterface
public interface Behavior {
    /// @param below what the layers under this one want
    /// @return what the robot should do: `below` itself to leave it alone
    Twist2d act(Percept percept, Twist2d below);

    /// What it is about, for people (`searching`, `following`); empty when there is nothing to tell.
    default String state() {
        return "";
    }
}
