package rsal.agents.patrol;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import rsal.agents.patrol.strategy.PatrolView;

/// Who patrols, by their reports. One whose reports stay away for five seconds counts as lost until it reports
/// again.
final class PatrolTeam {
    private static final Duration SILENCE = Duration.ofSeconds(5);

    private final Map<String, Heard> heard = new TreeMap<>(); // by agent

    private record Heard(PatrolReport report, Instant time) {}

    /// @param sender name of its agent
    void note(String sender, PatrolReport report, Instant now) {
        heard.put(sender, new Heard(report, now));
    }

    /// Lets a view know of all members and their reports.
    ///
    /// @param places that the view is of; reports have their numbers in the order
    /// @param self name of the agent whose view it is
    /// @param own what it does itself
    /// @param time the same instant in the view's time [s]
    void show(PatrolView view, ReachablePlaces places, String self, PatrolReport own, Instant now, double time) {
        var present = new TreeMap<String, Heard>();
        heard.forEach((name, last) -> {
            if (last.report.patrols() && last.time.plus(SILENCE).isAfter(now)) {
                present.put(name, last);
            }
        });
        present.put(self, new Heard(own, now));
        view.setTeam(present.headMap(self).size(), List.copyOf(present.keySet()));
        int member = 0;
        for (Heard last : present.values()) {
            PatrolReport report = last.report;
            int next = places.place(report.next());
            double age = Duration.between(last.time, now).toMillis() / 1000.0;
            view.report(
                    member++,
                    places.place(report.last()),
                    next,
                    next != PatrolView.NONE ? time + Math.max(0, report.remaining() - age) : Double.POSITIVE_INFINITY,
                    report.note().stream().mapToInt(Integer::intValue).toArray());
        }
    }
}
