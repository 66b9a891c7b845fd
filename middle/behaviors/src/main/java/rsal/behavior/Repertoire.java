package rsal.behavior;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import rsal.robot.RobotModel;

/// What people can tell any robot with a [Pilot] to do, by names that agents have, too.
public final class Repertoire {
    private static final Map<String, Function<RobotModel, Subsumption>> STACKS = new LinkedHashMap<>();

    static {
        STACKS.put("wander", PioneerStack::wander);
        STACKS.put("wall-follow", PioneerStack::followLeftWall);
    }

    private Repertoire() {}

    /// In the order in which people are shown them.
    public static List<String> names() {
        return List.copyOf(STACKS.keySet());
    }

    /// A new stack for a robot of a model; empty when there is none of that name.
    public static Optional<Subsumption> stack(String name, RobotModel model) {
        return Optional.ofNullable(STACKS.get(name)).map(make -> make.apply(model));
    }
}
