package rsal.agents.patrol;

import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntToDoubleFunction;
import rsal.agent.AgentContext;
import rsal.agent.Directory;
import rsal.agent.team.Team;
import rsal.agents.parts.AgentWords;
import rsal.data.Point2d;
import rsal.data.Pose2d;

/// Places as jobs of a team: each is a job again soon after somebody has been there, the more urgent the longer
/// nobody was: what A. Machado et al., "Multi-agent patrolling" (2002), call idleness, weighed against the path
/// as in A. Almeida et al., "Recent advances on multi-agent patrolling" (2004).
final class VisitBids {
    private static final Duration SEEN = Duration.ofSeconds(10); // nobody need look again before

    private final AgentContext self;
    private final Team team;
    private final Duration stay;
    private final double urgency;
    private final IntToDoubleFunction idle;
    private final Map<String, Integer> placeOf = new HashMap<>(); // by job
    private List<Pose2d> mapFromPlaces = List.of();

    /// @param idle time since nobody was at a place [s]
    VisitBids(AgentContext self, Team team, Duration stay, double urgency, IntToDoubleFunction idle) {
        this.self = self;
        this.team = team;
        this.stay = stay;
        this.urgency = urgency;
        this.idle = idle;
    }

    /// Calls for bids for all places.
    void begin(List<Point2d> mapFromThem) {
        mapFromPlaces = AgentWords.poses(mapFromThem);
        for (int place = 0; place < mapFromPlaces.size(); place++) {
            call(place);
        }
    }

    private void call(int place) {
        Pose2d there = mapFromPlaces.get(place);
        var visit = new Visit("visit " + AgentWords.place(there), there, stay, Optional.empty());
        placeOf.put(visit.name(), place);
        team.add(visit, () -> urgency * idle.applyAsDouble(place));
    }

    void note(Team.Event event) {
        if (event instanceof Team.Event.Done done) {
            int place = placeOf.getOrDefault(done.job().name(), 0);
            String robot = self.directory()
                    .find(done.member())
                    .map(Directory.Entry::robot)
                    .orElse("");
            self.publish(
                    Visited.TOPIC, new Visited(robot, mapFromPlaces.get(place).position()));
            self.scheduler().after(SEEN, () -> call(place));
        }
    }
}
