package rsal.testkit.fake;

import rsal.agent.AgentHost;
import rsal.agent.AgentHostProvider;
import rsal.settings.Arguments;
import rsal.time.Scheduler;

/// A multi-agent system with a clock of its own, to be chosen and never started. Tests name it as a service of theirs.
public final class ClockHost implements AgentHostProvider {
    public static final String KEY = "wallclock";

    @Override
    public String key() {
        return KEY;
    }

    @Override
    public String description() {
        return "Can only live in real time.";
    }

    @Override
    public boolean followsSchedulerTime() {
        return false;
    }

    @Override
    public AgentHost create(Arguments settings, Scheduler scheduler) {
        throw new IllegalStateException("No test starts it.");
    }
}
