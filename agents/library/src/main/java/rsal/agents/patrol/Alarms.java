package rsal.agents.patrol;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.agent.AgentContext;
import rsal.agent.team.Team;
import rsal.agents.patrol.Intruders.Track;
import rsal.data.Point2d;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Calls the nearest of a team to an intruder that one of them has seen, whatever they do meanwhile, and lets them go
/// when one of them has met it or nobody sees it any more. One that was met and stays there is no alarm any more.
final class Alarms {
    static final Parameter<Integer> RESPONDERS = Parameter.integer(
            "responders", 2, 0, 100, "", "Number of robots that are called when one of them sees an intruder.");

    private static final double URGENCY = 1e5; // m, more than any way and any place left alone
    private static final Duration LOOK = Duration.ofSeconds(1);
    private static final double LOST = 20; // s without a sighting
    private static final double STAYS = 3; // m, from where it was met

    private final AgentContext self;
    private final Team team;
    private final int responders;
    private final Intruders intruders = new Intruders();
    private final Map<Track, List<String>> inProgress = new HashMap<>(); // names of jobs
    private final List<Point2d> mapFromMet = new ArrayList<>();
    private int alarms;

    Alarms(AgentContext self, Arguments arguments, Team team) {
        this.self = self;
        this.team = team;
        this.responders = arguments.get(RESPONDERS);
    }

    void begin() {
        if (responders > 0) {
            self.subscribe(Alarm.TOPIC, message -> note(message.content().mapFromIntruder()));
            self.scheduler().every(LOOK, this::letGo);
        }
    }

    private void note(Point2d seen) {
        if (mapFromMet.stream().anyMatch(met -> met.distanceTo(seen) < STAYS)) {
            return;
        }
        Track track = intruders.note(seen, self.scheduler().instant());
        if (!inProgress.containsKey(track)) {
            raise(track);
        }
    }

    private void raise(Track track) {
        alarms++;
        var jobs = new ArrayList<String>();
        for (int i = 1; i <= responders; i++) {
            var job = new Meet("meet intruder %d (%d of %d)".formatted(alarms, i, responders), track.mapFromIntruder());
            jobs.add(job.name());
            team.add(job, () -> URGENCY);
        }
        inProgress.put(track, jobs);
        team.reallot();
    }

    /// A job has been done.
    void done(Meet job) {
        inProgress.entrySet().stream()
                .filter(alarm -> alarm.getValue().contains(job.name()))
                .map(Map.Entry::getKey)
                .findFirst()
                .ifPresent(track -> {
                    mapFromMet.add(track.mapFromIntruder());
                    end(track);
                });
    }

    private void letGo() {
        List<Track> lost = inProgress.keySet().stream()
                .filter(track -> track.age(self.scheduler().instant()) > LOST)
                .toList();
        lost.forEach(this::end);
    }

    private void end(Track track) {
        Optional.ofNullable(inProgress.remove(track)).ifPresent(jobs -> jobs.forEach(team::withdraw));
    }

    /// In words for people; empty when all is quiet.
    Optional<String> view() {
        return inProgress.isEmpty() ? Optional.empty() : Optional.of("alarm %d".formatted(alarms));
    }
}
