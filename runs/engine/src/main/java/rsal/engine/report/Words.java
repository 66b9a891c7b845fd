package rsal.engine.report;

import java.util.Locale;
import rsal.agent.Message;
import rsal.agent.MessageContent;
import rsal.agent.protocol.Act;
import rsal.data.Twist2d;
import rsal.device.Health;
import rsal.device.Navigator;

/// Says things in words for people.
public final class Words {
    private static final int MOST = 240; // characters of what is clipped

    private Words() {}

    public static String of(Message<?> message) {
        return message.content() instanceof Act act ? of(message.to(), act) : MessageContent.wordsOf(message.content());
    }

    /// `nav-1, request: nav-1, go to (1.00, 2.00, 0°)`
    private static String of(String to, Act act) {
        String about = MessageContent.wordsOf(act.content());
        return "%s, %s".formatted(to, act.performative()) + (about.isEmpty() ? "" : ": " + about);
    }

    /// What an act is about, in few words.
    public static String about(Act act) {
        return clipped(MessageContent.wordsOf(act.content()));
    }

    /// What a message says to the one who gets it, in few words.
    public static String clipped(Message<?> message) {
        return clipped(
                message.content() instanceof Act act
                        ? "%s %s"
                                .formatted(act.performative(), MessageContent.wordsOf(act.content()))
                                .strip()
                        : MessageContent.wordsOf(message.content()));
    }

    public static String clipped(String words) {
        return words.length() <= MOST ? words : words.substring(0, MOST) + "…";
    }

    /// How somebody drives: `stands`, `(0.40, 0.00) m/s, 29°/s`.
    public static String of(Twist2d velocity) {
        return velocity.equals(Twist2d.STOP)
                ? "stands"
                : String.format(
                        Locale.ROOT,
                        "(%.2f, %.2f) m/s, %.0f°/s",
                        velocity.vx(),
                        velocity.vy(),
                        Math.toDegrees(velocity.omega()));
    }

    /// How a way ended.
    public static String of(Navigator.Result result) {
        return switch (result) {
            case Navigator.Result.Reached(var _, String doubt) -> doubt.isEmpty() ? "reached" : "unsure. " + doubt;
            case Navigator.Result.Cancelled(String why) -> "cancelled. " + why;
            case Navigator.Result.NoPath(String why) -> "no path. " + why;
            case Navigator.Result.Stuck(var _, var _, String why) -> "stuck. " + why;
        };
    }

    public static String of(Health health) {
        return switch (health) {
            case Health.Ok _ -> "works";
            case Health.Stale(String reason) -> "is stale: " + reason;
            case Health.Lost(String reason) -> "is lost: " + reason;
        };
    }
}
