package rsal.agents.parts;

import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.stream.Collectors;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.Navigator.Result;

/// How agents put things to people, the same on every machine.
public final class AgentWords {
    private static final int LISTED = 12;

    private AgentWords() {}

    /// `(3.2, -1.0)`
    public static String place(Pose2d mapFromPlace) {
        return String.format(Locale.ROOT, "(%.1f, %.1f)", mapFromPlace.x(), mapFromPlace.y());
    }

    /// Places as goals, where no heading is asked for.
    public static List<Pose2d> poses(List<Point2d> mapFromPlaces) {
        return mapFromPlaces.stream().map(AgentWords::pose).toList();
    }

    public static Pose2d pose(Point2d mapFromPlace) {
        return new Pose2d(mapFromPlace.x(), mapFromPlace.y(), 0);
    }

    /// `a, b, c`; of more than a line holds only the first, and how many there are.
    public static <T> String list(List<T> all, Function<T, String> word) {
        String first = all.stream().limit(LISTED).map(word).collect(Collectors.joining(", "));
        return all.size() <= LISTED ? first : "%s, … (%d)".formatted(first, all.size());
    }

    /// `2.4 m`
    public static String distance(double meters) {
        return String.format(Locale.ROOT, "%.1f m", meters);
    }

    /// As [rsal.agent.message.GoalReached] says it.
    public static String ending(Result result) {
        return switch (result) {
            case Result.Reached reached -> reached.isSure() ? "reached" : "unsure";
            case Result.Cancelled _ -> "cancelled";
            case Result.NoPath _ -> "no path";
            case Result.Stuck _ -> "stuck";
        };
    }

    /// As [rsal.agent.message.GoalReached] says it.
    public static String reason(Result result) {
        return switch (result) {
            case Result.Reached(var _, String doubt) -> doubt;
            case Result.Cancelled _ -> "";
            case Result.NoPath(String why) -> why;
            case Result.Stuck stuck -> stuck.why();
        };
    }
}
