package rsal.agent.message;

import java.util.List;
import java.util.stream.Collectors;
import rsal.agent.MessageContent;
import rsal.agent.Topic;
import rsal.data.Point2d;

/// A team watches these places from now on, and none that were said before.
public record Watch(List<Point2d> mapFromPlaces) implements MessageContent {
    public static final Topic<Watch> TOPIC = new Topic<>("watch", Watch.class);

    public Watch {
        mapFromPlaces = List.copyOf(mapFromPlaces);
        mapFromPlaces.forEach(place -> Check.somewhere("place", place));
    }

    @Override
    public String words() {
        return mapFromPlaces.stream().map(Point2d::rounded).collect(Collectors.joining(", ", "We watch ", ""));
    }
}
