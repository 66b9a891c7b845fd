package rsal.agents.patrol;

import java.util.List;
import java.util.stream.Collectors;
import rsal.agent.MessageContent;
import rsal.agent.Topic;
import rsal.agent.message.MessageCheck;
import rsal.data.Point2d;

/// The team watches these places from now on, instead of those before.
///
/// @param mapFromPlaces the places, in the map frame [m]
public record Watch(List<Point2d> mapFromPlaces) implements MessageContent {
    public static final Topic<Watch> TOPIC = new Topic<>("watch", Watch.class);

    public Watch {
        mapFromPlaces = List.copyOf(mapFromPlaces);
        mapFromPlaces.forEach(place -> MessageCheck.somewhere("place", place));
    }

    @Override
    public String words() {
        return mapFromPlaces.stream().map(Point2d::rounded).collect(Collectors.joining(", ", "We watch ", ""));
    }
}
