package rsal.agents.foraging;

import java.util.Locale;
import rsal.agent.MessageContent;
import rsal.agent.Topic;
import rsal.agent.message.MessageCheck;
import rsal.data.Point2d;
import rsal.data.Rgb;

/// Something lies somewhere and is to be collected. The agent that does so says it every few seconds; of what was not
/// heard of for longer nobody takes care.
///
/// @param color as cameras see it
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
