package rsal.agents.exploration;

import java.util.List;
import java.util.Optional;
import rsal.agent.MessageContent;
import rsal.agent.Topic;
import rsal.agent.message.MessageCheck;
import rsal.data.Point2d;

/// The frontiers of the map of a robot, where known free space meets unknown space. The robot repeats this.
///
/// @param robot its id
/// @param ends the frontiers that it can reach; empty when all is mapped
public record MapEnds(String robot, List<End> ends) implements MessageContent {
    public static final Topic<MapEnds> TOPIC = new Topic<>("map-ends", MapEnds.class);

    /// At most so many are told; there will be others when these are mapped.
    public static final int MOST = 50;

    public MapEnds {
        MessageCheck.given("robot", robot);
        ends = List.copyOf(ends);
        if (ends.size() > MOST) {
            throw new IllegalArgumentException("'%s' reports %d frontiers of its map; at most %d are allowed."
                    .formatted(robot, ends.size(), MOST));
        }
    }

    /// Where what is free meets what nobody has seen.
    ///
    /// @param length of that [m]
    public record End(Point2d mapFromMiddle, double length) {
        public End {
            MessageCheck.somewhere("middle", mapFromMiddle);
            if (!(length >= 0)) {
                throw new IllegalArgumentException("The end of a map must be long, not '%s' m.".formatted(length));
            }
        }
    }

    @Override
    public String words() {
        return "map of %s ends at %d places".formatted(robot, ends.size());
    }

    /// It is said again and again.
    @Override
    public Optional<String> eventKind() {
        return Optional.empty();
    }
}
