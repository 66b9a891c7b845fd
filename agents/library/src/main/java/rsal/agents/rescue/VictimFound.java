package rsal.agents.rescue;

import java.util.Locale;
import rsal.agent.MessageContent;
import rsal.agent.Topic;
import rsal.agent.message.MessageCheck;
import rsal.data.Point2d;

/// A robot has seen a victim. It repeats this every few seconds until it hears that the victim was helped
/// ([VictimHelped]), and when it has measured the position more exactly.
///
/// @param robot its id
/// @param victim number of the victim's marker
/// @param mapFromVictim where the victim is, in the map frame, as the robot believes [m]
public record VictimFound(String robot, int victim, Point2d mapFromVictim) implements MessageContent {
    public static final Topic<VictimFound> TOPIC = new Topic<>("victim-found", VictimFound.class);

    public VictimFound {
        MessageCheck.given("robot", robot);
        MessageCheck.somewhere("victim", mapFromVictim);
    }

    /// `victim 3 is at (3.2, -1.0)`
    @Override
    public String toString() {
        return String.format(Locale.ROOT, "victim %d is at (%.1f, %.1f)", victim, mapFromVictim.x(), mapFromVictim.y());
    }
}
