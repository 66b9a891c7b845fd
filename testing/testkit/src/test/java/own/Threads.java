package own;

import java.util.List;
import rsal.agent.AgentHost;
import rsal.agent.AgentHostProvider;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.time.Scheduler;

/// A multi-agent system that is nothing but a thread for each agent.
public final class Threads implements AgentHostProvider {
    private static final Parameter<Boolean> MAIL =
            Parameter.flag("mail", false, "Whether a mailman brings what agents say.");

    @Override
    public String key() {
        return "threads";
    }

    @Override
    public String description() {
        return "Gives each agent a thread of its own, in real time.";
    }

    @Override
    public boolean followsSchedulerTime() {
        return false; // threads wait by the clock of the machine
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(MAIL);
    }

    @Override
    public AgentHost create(Arguments settings, Scheduler scheduler) {
        return new ThreadsHost(scheduler, settings.get(MAIL));
    }
}
