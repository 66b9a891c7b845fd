package rsal.navigation.device;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeMap;
import rsal.navigation.traffic.IntersectionReport;
import rsal.robot.TeamLink;
import rsal.time.Scheduler;

/// Where the others of a team say that they are, as far as this robot hears them. Who does not take part in traffic by
/// messages says nothing.
final class TeamPoses {
    private static final Duration FRESH = Duration.ofMillis(2500);

    private final Scheduler scheduler;
    private final TreeMap<String, Said> all = new TreeMap<>();

    private record Said(Mate mate, Instant at) {}

    TeamPoses(TeamLink link, Scheduler scheduler) {
        this.scheduler = scheduler;
        link.onMessage(IntersectionReport.class, this::heard);
    }

    private void heard(String robot, IntersectionReport report) {
        all.put(robot, new Said(new Mate(report.mapFromBase().position(), report.radius()), scheduler.instant()));
    }

    /// Those that were heard just now.
    List<Mate> now() {
        if (all.isEmpty()) {
            return List.of();
        }
        var mates = new ArrayList<Mate>(all.size());
        Instant oldest = scheduler.instant().minus(FRESH);
        for (Said said : all.values()) {
            if (!said.at().isBefore(oldest)) {
                mates.add(said.mate());
            }
        }
        return mates;
    }
}
