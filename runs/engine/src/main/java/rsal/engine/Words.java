package rsal.engine;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import rsal.agent.Message;
import rsal.agent.message.Alarm;
import rsal.agent.message.Caught;
import rsal.agent.message.ChargerTaken;
import rsal.agent.message.Chase;
import rsal.agent.message.Collected;
import rsal.agent.message.Depot;
import rsal.agent.message.GoalReached;
import rsal.agent.message.Hello;
import rsal.agent.message.Lookout;
import rsal.agent.message.MapEnds;
import rsal.agent.message.NewGoal;
import rsal.agent.message.PoseReport;
import rsal.agent.message.PoseRequest;
import rsal.agent.message.Sighting;
import rsal.agent.message.Text;
import rsal.agent.message.Visited;
import rsal.agent.message.Watch;
import rsal.agent.protocol.Act;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.Health;
import rsal.device.Navigator;

/// Says things in words for people.
final class Words {
    private static final int MOST = 240; // characters of what is clipped

    private Words() {}

    static String of(Message<?> message) {
        return message.content() instanceof Act act ? of(message.to(), act) : content(message.content());
    }

    /// `nav-1, request: nav-1, go to (1.00, 2.00, 0°)`
    private static String of(String to, Act act) {
        String about = content(act.content());
        return "%s, %s".formatted(to, act.performative()) + (about.isEmpty() ? "" : ": " + about);
    }

    /// What an act is about, in few words.
    static String about(Act act) {
        return clipped(content(act.content()));
    }

    /// What a message says to the one who gets it, in few words.
    static String clipped(Message<?> message) {
        return clipped(
                message.content() instanceof Act act
                        ? "%s %s"
                                .formatted(act.performative(), content(act.content()))
                                .strip()
                        : content(message.content()));
    }

    static String clipped(String words) {
        return words.length() <= MOST ? words : words.substring(0, MOST) + "…";
    }

    private static String content(Object content) {
        return switch (content) {
            case MapEnds told ->
                "map of %s ends at %d places"
                        .formatted(told.robot(), told.ends().size());
            case PoseReport report -> "%s is at %s".formatted(report.robot(), of(report.mapFromBase()));
            case PoseRequest request -> "%s, where are you?".formatted(request.robot());
            case NewGoal goal -> "%s, go to %s".formatted(goal.robot(), of(goal.mapFromGoal()));
            case GoalReached end -> "%s at %s: %s".formatted(end.robot(), of(end.mapFromGoal()), end.words());
            case Caught caught ->
                String.format(
                        Locale.ROOT,
                        "%s is caught by %s, believed at %.2f m",
                        caught.prey(),
                        caught.hunter(),
                        caught.distance());
            case Chase chase when chase.prey().isEmpty() -> "%s cuts a prey off".formatted(chase.hunter());
            case Chase chase -> "%s goes for %s".formatted(chase.hunter(), chase.prey());
            case Sighting sighting -> "I see %s at %s".formatted(sighting.robot(), of(sighting.mapFromBase()));
            case Depot depot -> "%s brings things to %s".formatted(depot.robot(), of(depot.mapFromDepot()));
            case Lookout lookout
            when lookout.done() -> "%s has looked around at %s".formatted(lookout.robot(), of(lookout.mapFromPlace()));
            case Lookout lookout ->
                "%s goes to look around at %s".formatted(lookout.robot(), of(lookout.mapFromPlace()));
            case Collected collected ->
                "%s has brought %s to %s".formatted(collected.robot(), collected.goal(), of(collected.mapFromDepot()));
            case Watch watch -> "We watch " + of(watch.mapFromPlaces());
            case Visited visited -> "%s was at %s".formatted(visited.robot(), of(visited.mapFromPlace()));
            case ChargerTaken taken -> "%s has the charger at %s".formatted(taken.robot(), of(taken.mapFromCharger()));
            case Alarm alarm -> "%s sees an intruder at %s".formatted(alarm.robot(), of(alarm.mapFromIntruder()));
            case Hello hello -> of(hello);
            case Text text -> text.words();
            default -> content.toString();
        };
    }

    private static String of(List<Point2d> places) {
        return places.stream().map(Words::of).collect(Collectors.joining(", "));
    }

    /// `(1.23, -4.50)`.
    static String of(Point2d place) {
        return String.format(Locale.ROOT, "(%.2f, %.2f)", place.x(), place.y());
    }

    private static String of(Hello hello) {
        return switch (hello.kind()) {
            case HELLO -> "Hello, I am here.";
            case PING -> "Who is there?";
            case PONG -> "%s, I am here.".formatted(hello.to());
            case BYE -> "Bye.";
        };
    }

    /// `(1.23, -4.50, 90°)`.
    static String of(Pose2d pose) {
        return String.format(Locale.ROOT, "(%.2f, %.2f, %.0f°)", pose.x(), pose.y(), Math.toDegrees(pose.theta()));
    }

    /// How somebody drives: `stands`, `(0.40, 0.00) m/s, 29°/s`.
    static String of(Twist2d velocity) {
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
    static String of(Navigator.Result result) {
        return switch (result) {
            case Navigator.Result.Reached(var _, String doubt) -> doubt.isEmpty() ? "reached" : "unsure. " + doubt;
            case Navigator.Result.Cancelled(String why) -> "cancelled. " + why;
            case Navigator.Result.NoPath(String why) -> "no path. " + why;
            case Navigator.Result.Stuck(var _, var _, String why) -> "stuck. " + why;
        };
    }

    static String of(Health health) {
        return switch (health) {
            case Health.Ok _ -> "works";
            case Health.Stale(String reason) -> "is stale: " + reason;
            case Health.Lost(String reason) -> "is lost: " + reason;
        };
    }
}
