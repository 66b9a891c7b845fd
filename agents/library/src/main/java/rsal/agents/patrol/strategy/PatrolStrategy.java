package rsal.agents.patrol.strategy;

/// How one robot decides which place it visits next. Keeps what it needs to remember; is asked on one thread.
public interface PatrolStrategy {
    /// Where to go now that the robot has visited a place, or its team has changed.
    ///
    /// @return number of a place; the one where the robot is lets it wait there for a second
    int next(PatrolView view);

    /// What others should know of its decisions, besides where the robot goes: a few numbers that
    /// [PatrolView#note] then has at each member. Sent once a second, at most 4,000 numbers.
    default int[] note() {
        return new int[0];
    }
}
