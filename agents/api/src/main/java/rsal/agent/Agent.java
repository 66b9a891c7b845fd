package rsal.agent;

/// Decides what a robot (or a team) should do. All calls come on the agent's own lane; nothing in it may block.
public interface Agent {
    /// Begins: subscribe, set timers, set off. An exception ends this agent alone and is reported with its name.
    void start(AgentContext self);

    /// The run ends or the agent is stopped: the moment for last words. Its subscriptions and timers end by
    /// themselves; its robot is stopped by the robot's watchdog. Not called after an exception.
    default void stop(AgentContext self) {}
}
