package rsal.testkit.fake;

import java.util.List;
import rsal.settings.Parameter;
import rsal.system.RobotSystem;
import rsal.system.RobotSystemProvider;
import rsal.time.Scheduler;

/// The robot system `fake`.
public final class FakeProvider implements RobotSystemProvider {
    @Override
    public String key() {
        return "fake";
    }

    @Override
    public String description() {
        return "Robots that exist only for tests.";
    }

    @Override
    public boolean followsSchedulerTime() {
        return true;
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of();
    }

    @Override
    public RobotSystem create(Config config, Scheduler scheduler) {
        return new FakeSystem(config, scheduler);
    }
}
