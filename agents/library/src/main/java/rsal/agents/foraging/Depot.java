package rsal.agents.foraging;

import rsal.agent.MessageContent;
import rsal.agent.Topic;
import rsal.agent.message.MessageCheck;
import rsal.data.Point2d;

/// A robot brings things to this place. Do not collect things that lie there.
///
/// @param robot its id
/// @param mapFromDepot middle of the depot, in the map frame [m]
/// @param radius of the depot [m]
public record Depot(String robot, Point2d mapFromDepot, double radius) implements MessageContent {
    public static final Topic<Depot> TOPIC = new Topic<>("depot", Depot.class);

    public Depot {
        MessageCheck.given("robot", robot);
        MessageCheck.somewhere("depot", mapFromDepot);
        if (!(radius >= 0)) {
            throw new IllegalArgumentException("A depot must have a radius, not '%s'.".formatted(radius));
        }
    }

    public boolean holds(Point2d mapFromThing) {
        return mapFromDepot.distanceTo(mapFromThing) <= radius;
    }

    @Override
    public String words() {
        return "%s brings things to %s".formatted(robot, mapFromDepot.rounded());
    }
}
