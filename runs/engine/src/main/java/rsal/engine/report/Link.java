package rsal.engine.report;

/// How the agents of two robots hear each other.
///
/// @param one id of a robot
/// @param other the same
/// @param there from the one to the other
/// @param back from the other to the one
public record Link(String one, String other, Way there, Way back) {
    /// @param open whether what is said now would be heard, but for chance
    /// @param used whether something was heard within the last second
    public record Way(boolean open, boolean used) {
        public boolean isWorthTelling() {
            return open || used;
        }
    }
}
