package rsal.recording;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.engine.report.AgentView;
import rsal.engine.report.RobotView;
import rsal.engine.report.Snapshot;

/// In what two moments differ that should be the same, in words.
final class Differences {
    private static final int MOST = 10;

    private Differences() {}

    /// A line for each robot and agent that differs, with the first value that does: as it was recorded, then as it
    /// is now, with all digits. Of many lines the first [#MOST]. Empty when only what was said differs.
    static List<String> between(Snapshot recorded, Snapshot now) {
        List<String> all = Stream.concat(
                        differing(recorded.robots(), now.robots(), RobotView::id, Differences::reported),
                        differing(
                                recorded.agents(),
                                now.agents(),
                                agent -> agent.view().agent().name(),
                                Differences::reported))
                .toList();
        if (all.size() <= MOST) {
            return all;
        }
        var first = new ArrayList<>(all.subList(0, MOST));
        first.add("and %d more".formatted(all.size() - MOST));
        return List.copyOf(first);
    }

    private static <T> Stream<String> differing(
            List<T> recorded, List<T> now, Function<T, String> name, Function<T, Map<String, String>> reported) {
        var before = new LinkedHashMap<String, Map<String, String>>();
        recorded.forEach(one -> before.put(name.apply(one), reported.apply(one)));
        var lines = new ArrayList<String>();
        for (T one : now) {
            Optional<Map<String, String>> same = Optional.ofNullable(before.remove(name.apply(one)));
            if (same.isEmpty()) {
                lines.add("%s: not recorded, there now".formatted(name.apply(one)));
            } else {
                reported.apply(one).entrySet().stream()
                        .filter(value ->
                                !Objects.equals(value.getValue(), same.get().get(value.getKey())))
                        .findFirst()
                        .ifPresent(value -> lines.add("%s: %s %s recorded, %s now"
                                .formatted(
                                        name.apply(one),
                                        value.getKey(),
                                        same.get().get(value.getKey()),
                                        value.getValue())));
            }
        }
        before.keySet().forEach(missing -> lines.add("%s: recorded, not there now".formatted(missing)));
        return lines.stream();
    }

    private static Map<String, String> reported(RobotView robot) {
        var values = new LinkedHashMap<String, String>();
        values.put("gone", Boolean.toString(robot.gone()));
        values.put("true pose", words(robot.truth()));
        values.put("odometry", words(robot.odometry().map(Stamped::value).map(value -> value.odomFromBase())));
        values.put("estimated pose", words(robot.estimate().map(Stamped::value).map(value -> value.mapFromBase())));
        values.put("goal", words(robot.goal()));
        values.put("in charge", "'" + robot.inCharge() + "'");
        return values;
    }

    private static Map<String, String> reported(AgentView agent) {
        var values = new LinkedHashMap<String, String>();
        values.put("status", agent.view().status().name());
        values.put("state", "'" + agent.view().state() + "'");
        values.put("beliefs", agent.view().beliefs().toString());
        return values;
    }

    private static String words(Optional<Pose2d> pose) {
        return pose.map(known -> "(%s m, %s m, %s rad)".formatted(known.x(), known.y(), known.theta()))
                .orElse("none");
    }
}
