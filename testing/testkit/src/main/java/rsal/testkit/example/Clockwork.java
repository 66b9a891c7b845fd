package rsal.testkit.example;

/// Robots that go by their own clocks.
public final class Clockwork extends Reality {
    @Override
    public String key() {
        return "clockwork";
    }

    @Override
    public boolean followsSchedulerTime() {
        return false;
    }
}
