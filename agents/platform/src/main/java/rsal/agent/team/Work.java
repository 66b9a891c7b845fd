package rsal.agent.team;

/// A job under way, for the one that does it. What is said after its end does nothing. On the agent's lane.
public interface Work {
    /// @param report in a few words the result
    void done(String report);

    /// It can't be done, or not by this one. Another gets it.
    void fail(String why);

    /// Runs once when it is over, however it ended, also when nobody wants it any more: lets go of the robot.
    void onEnd(Runnable lettingGo);

    boolean isOver();
}
