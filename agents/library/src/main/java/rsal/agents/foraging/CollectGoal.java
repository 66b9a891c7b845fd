package rsal.agents.foraging;

import java.util.Locale;
import rsal.agent.MessageContent;
import rsal.agent.Topic;
import rsal.agent.message.MessageCheck;
import rsal.data.Point2d;
import rsal.data.Rgb;

/// A thing lies at a place and is to be collected. The agent that knows the thing repeats this every few
/// seconds; without this message for longer, agents forget the thing.
///
/// @param color its color, as cameras see it
/// @param mapFromThing where it lies, in the map frame [m]
public record CollectGoal(Rgb color, Point2d mapFromThing) implements MessageContent {
    public static final Topic<CollectGoal> TOPIC = new Topic<>("collect-goal", CollectGoal.class);

    private static final double APART = 0.6; // m; what is nearer to each other is taken for one thing

    public CollectGoal {
        MessageCheck.given("color", color);
        MessageCheck.somewhere("thing", mapFromThing);
    }

    /// Whether both are of the same thing: of one color, and not farther apart than robots mistake themselves.
    public boolean isSame(CollectGoal other) {
        return color.equals(other.color) && mapFromThing.distanceTo(other.mapFromThing) < APART;
    }

    /// `#2ca02c at (3.2, -1.0)`
    @Override
    public String toString() {
        return String.format(Locale.ROOT, "%s at (%.1f, %.1f)", color, mapFromThing.x(), mapFromThing.y());
    }
}
