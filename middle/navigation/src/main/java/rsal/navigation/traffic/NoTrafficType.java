package rsal.navigation.traffic;

import rsal.settings.Arguments;

/// Other robots are obstacles only.
public final class NoTrafficType implements TrafficType {
    @Override
    public String key() {
        return "none";
    }

    @Override
    public String description() {
        return "Other robots are obstacles only; for opponents, and robots that are alone.";
    }

    @Override
    public TrafficRule create(Arguments arguments, Participant participant) {
        return TrafficRule.NONE;
    }
}
