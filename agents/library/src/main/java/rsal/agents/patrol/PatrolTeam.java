package rsal.agents.patrol;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
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
    /// @param self name of the agent whose view it is
    /// @param own what it does itself
    /// @param time the same instant in the view's time [s]
    void show(PatrolView view, String self, PatrolReport own, Instant now, double time) {
        var present = new TreeMap<String, Heard>();
        heard.forEach((name, last) -> {
            if (last.report.patrols() && last.time.plus(SILENCE).isAfter(now)) {
                present.put(name, last);
            }
        });
        present.put(self, new Heard(own, now));
        List<String> names = new ArrayList<>(present.keySet());
        view.setTeam(names.indexOf(self), names.size());
        int places = view.graph().size();
        for (int member = 0; member < names.size(); member++) {
            Heard last = Objects.requireNonNull(present.get(names.get(member)));
            PatrolReport report = last.report;
            boolean goes = isPlace(report.next(), places);
            double age = Duration.between(last.time, now).toMillis() / 1000.0;
            view.report(
                    member,
                    isPlace(report.last(), places) ? report.last() : PatrolView.NONE,
                    goes ? report.next() : PatrolView.NONE,
                    goes ? time + Math.max(0, report.remaining() - age) : Double.POSITIVE_INFINITY,
                    report.note().stream().mapToInt(Integer::intValue).toArray());
        }
    }

    private static boolean isPlace(int number, int places) {
        return number >= 0 && number < places;
    }
}
