package rsal.navigation.traffic;

import java.util.List;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// One direction at a time through narrow passages, agreed by messages.
public final class RightOfWayType implements TrafficType {
    static final Parameter<Double> CLAIM_DISTANCE = Parameter.number(
            "claimDistance", 3.5, 1, 20, "m", "length of path before a narrow passage from which on a robot claims it");
    private static final Parameter<Integer> BATCH = Parameter.integer(
            "batch", 3, 1, 100, "", "maximum number of robots in one direction while others wait for the other one");
    static final Parameter<Double> CLOSE_AFTER = Parameter.number(
            "closeAfter",
            60,
            5,
            3600,
            "s",
            "time after which a passage is closed to the planner, in which a robot does not move");
    static final Parameter<Boolean> JUNCTIONS =
            Parameter.flag("junctions", true, "keep to the right in corridors, and take turns where they meet");

    @Override
    public String key() {
        return "rightOfWay";
    }

    @Override
    public String description() {
        return "Robots agree by messages who goes first through narrow passages; the others wait beside the gates.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(CLAIM_DISTANCE, BATCH, CLOSE_AFTER, JUNCTIONS);
    }

    @Override
    public TrafficRule create(Arguments arguments, Participant participant) {
        return rule(arguments, participant, arguments.get(BATCH), Tickets::new);
    }

    static TrafficRule rule(Arguments arguments, Participant participant, int batch, Agreement.Maker how) {
        var passages = new RightOfWay(
                participant,
                new RightOfWay.Settings(arguments.get(CLAIM_DISTANCE), batch, arguments.seconds(CLOSE_AFTER)),
                how);
        return arguments.get(JUNCTIONS) ? new TeamTraffic(passages, new Intersections(participant)) : passages;
    }
}
