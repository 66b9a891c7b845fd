package rsal.engine.report;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import rsal.agent.bdi.Mind;
import rsal.engine.report.MindChange.Kind;

/// What an agent believes and wants, in words for people.
///
/// @param beliefs by name
/// @param goals by name, each with its state and steps
public record MindWords(Map<String, String> beliefs, Map<String, String> goals) {
    /// @param goals several of one name are put together, as a plan may want the same twice
    public static MindWords of(Map<String, String> beliefs, List<Mind.GoalView> goals) {
        var wanted = new LinkedHashMap<String, String>();
        goals.forEach(goal -> wanted.merge(goal.name(), words(goal), (one, more) -> one + "; " + more));
        return new MindWords(beliefs, wanted);
    }

    private static String words(Mind.GoalView goal) {
        String state = goal.state().name().toLowerCase(Locale.ROOT).replace('_', ' ');
        String steps = goal.steps().isEmpty() ? "" : ": " + String.join(" > ", goal.steps());
        return state + steps;
    }

    /// What differs later.
    ///
    /// @param time of the later look, since the run's start
    public List<MindChange> changesTo(MindWords later, Duration time) {
        var changes = new ArrayList<MindChange>();
        change(changes, Kind.BELIEVES, beliefs, later.beliefs, time);
        change(changes, Kind.WANTS, goals, later.goals, time);
        return changes;
    }

    private static void change(
            List<MindChange> changes, Kind kind, Map<String, String> before, Map<String, String> now, Duration time) {
        now.forEach((name, words) -> {
            if (!words.equals(before.get(name))) {
                changes.add(new MindChange(time, kind, name, Words.clipped(words)));
            }
        });
        before.keySet().stream()
                .filter(name -> !now.containsKey(name))
                .forEach(name -> changes.add(new MindChange(time, kind, name, "")));
    }
}
