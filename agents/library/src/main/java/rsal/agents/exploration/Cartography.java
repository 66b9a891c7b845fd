package rsal.agents.exploration;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import rsal.agent.AgentContext;
import rsal.agent.team.Objective;
import rsal.agent.team.Rules;
import rsal.agent.team.Team;
import rsal.data.Point2d;

/// What a team that maps a place has to do: each end of its map, as any of them tells it, is a job until the map goes
/// on there. Which robot goes where they settle by bids, again every few seconds, as ends come and go.
final class Cartography {
    private static final Duration MEMORY = Duration.ofSeconds(12); // of what a robot told; three words of it

    private static final Duration ANEW = Duration.ofSeconds(6);
    private static final double WORTH = 0.5; // m of way that a meter of end is worth, as when robots settle it alone
    private static final double MOST_WORTH = 3; // m

    private final AgentContext self;
    private final Team team;
    private final Map<String, Reported> reported = new TreeMap<>(); // by robot
    private List<Chart> jobs = List.of();

    private record Reported(List<MapEnds.End> ends, Instant when) {}

    Cartography(AgentContext self) {
        this.self = self;
        Rules rules = Rules.DEFAULT.withObjective(Objective.SUM).withTries(0).reconsideredEvery(ANEW);
        this.team = new Team(self, rules, _ -> {});
    }

    void begin() {
        self.subscribe(MapEnds.TOPIC, message -> {
            MapEnds news = message.content();
            reported.put(
                    news.robot(), new Reported(news.ends(), self.scheduler().instant()));
            update();
        });
        team.begin();
        self.state("waiting for a map");
    }

    private void update() {
        Instant then = self.scheduler().instant().minus(MEMORY);
        reported.values().removeIf(one -> one.when.isBefore(then));
        List<MapEnds.End> ends = ends();
        var open = new ArrayList<Chart>();
        for (Chart job : jobs) {
            if (ends.stream().anyMatch(end -> isSame(job.mapFromEnd(), end))) {
                open.add(job);
            } else {
                team.withdraw(job.name());
            }
        }
        for (MapEnds.End end : ends) {
            if (open.stream().noneMatch(job -> isSame(job.mapFromEnd(), end))) {
                open.add(new Chart(end.mapFromMiddle()));
            }
        }
        for (Chart job : open) {
            if (!team.has(job.name())) { // new, or somebody was there and it is there still
                team.add(job, () -> worth(job));
            }
        }
        jobs = List.copyOf(open);
        self.state(jobs.isEmpty() ? "all is mapped" : "places where the map ends: " + jobs.size());
    }

    /// How much longer a way it is worth [m].
    private double worth(Chart job) {
        return ends().stream()
                .filter(end -> isSame(job.mapFromEnd(), end))
                .mapToDouble(end -> Math.min(MOST_WORTH, WORTH * end.length()))
                .max()
                .orElse(0);
    }

    /// As all tell them, each once.
    private List<MapEnds.End> ends() {
        var ends = new ArrayList<MapEnds.End>();
        for (Reported one : reported.values()) {
            for (MapEnds.End end : one.ends) {
                if (ends.stream().noneMatch(other -> isSame(other.mapFromMiddle(), end))) {
                    ends.add(end);
                }
            }
        }
        return ends;
    }

    private static boolean isSame(Point2d place, MapEnds.End end) {
        return end.mapFromMiddle().distanceTo(place) < Charting.SAME;
    }
}
