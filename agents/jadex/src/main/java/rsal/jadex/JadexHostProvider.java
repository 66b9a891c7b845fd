package rsal.jadex;

import rsal.agent.AgentHost;
import rsal.agent.AgentHostProvider;
import rsal.settings.Arguments;
import rsal.time.Scheduler;

/// Runs agents on Jadex 4, in real time: its clock is its own. Needs `--sun-misc-unsafe-memory-access=allow` to be
/// quiet on newer JDKs.
public final class JadexHostProvider implements AgentHostProvider {
    @Override
    public String key() {
        return "jadex";
    }

    @Override
    public String description() {
        return "Runs agents on Jadex in real time: each is a micro agent.";
    }

    @Override
    public boolean followsSchedulerTime() {
        return false;
    }

    @Override
    public AgentHost create(Arguments settings, Scheduler scheduler) {
        return new JadexHost(scheduler, LonelyPlatform.start());
    }
}
