package rsal.agents.rescue;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import rsal.agent.AgentContext;
import rsal.data.Fiducials;
import rsal.data.Fiducials.Fiducial;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.device.FiducialFinder;
import rsal.device.Localizer;
import rsal.robot.Robot;

/// Looks for victims by a robot's finder of markers and tells the others, of each again and again until somebody says
/// that it was helped. Knows where those are that others found, too: the newest word counts. Markers that are too far
/// away to be read, and all while the robot is lost, are left out.
final class Scouting {
    private static final Duration AGAIN = Duration.ofSeconds(5);
    private static final double MOVED = 0.3; // m; is said at once

    private final AgentContext self;
    private final String robot;
    private final FiducialFinder finder;
    private final Localizer localizer;
    private final Map<Integer, Point2d> mapFromVictims = new TreeMap<>(); // all that are known
    private final Map<Integer, Point2d> found = new TreeMap<>(); // by this robot, as said last
    private final Set<Integer> helped = new TreeSet<>();
    private Map<Integer, Point2d> inSight = Map.of(); // in the robot's frame

    Scouting(AgentContext self, Robot robot) {
        this.self = self;
        this.robot = robot.id();
        this.finder = robot.require(FiducialFinder.class);
        this.localizer = robot.require(Localizer.class);
    }

    void begin() {
        self.subscribe(finder, reading -> look(reading.value()));
        self.subscribe(VictimFound.TOPIC, message -> {
            VictimFound said = message.content();
            mapFromVictims.put(said.victim(), said.mapFromVictim());
        });
        self.subscribe(VictimHelped.TOPIC, message -> {
            helped.add(message.content().victim());
            show();
        });
        self.scheduler().every(AGAIN, this::sayAgain);
        show();
    }

    /// Where a victim is, as far as anybody said.
    Optional<Point2d> mapFromVictim(int victim) {
        return Optional.ofNullable(mapFromVictims.get(victim));
    }

    /// Where a victim is that the robot sees now.
    Optional<Point2d> baseFromVictim(int victim) {
        return Optional.ofNullable(inSight.get(victim));
    }

    private void look(Fiducials seen) {
        var now = new TreeMap<Integer, Point2d>();
        for (Fiducial fiducial : seen.fiducials()) {
            fiducial.id()
                    .ifPresent(id -> now.put(id, fiducial.baseFromFiducial().position()));
        }
        inSight = now;
        mapFromBase()
                .ifPresent(mapFromBase -> now.forEach((victim, baseFromVictim) -> {
                    Point2d mapFromVictim = mapFromBase.transform(baseFromVictim);
                    mapFromVictims.put(victim, mapFromVictim);
                    Point2d said = found.get(victim);
                    boolean news = said == null || said.distanceTo(mapFromVictim) > MOVED;
                    if (news && !helped.contains(victim)) {
                        say(victim);
                        show();
                    }
                }));
    }

    private Optional<Pose2d> mapFromBase() {
        return localizer
                .latest()
                .filter(estimate -> estimate.value().quality() != PoseEstimate.Quality.LOST)
                .map(estimate -> estimate.value().mapFromBase());
    }

    private void sayAgain() {
        found.keySet().stream().filter(victim -> !helped.contains(victim)).forEach(this::say);
    }

    private void say(int victim) {
        Point2d mapFromVictim = mapFromVictims.get(victim);
        if (mapFromVictim != null) {
            found.put(victim, mapFromVictim);
            self.publish(VictimFound.TOPIC, new VictimFound(robot, victim, mapFromVictim));
        }
    }

    private void show() {
        self.show(
                "victims found",
                found.isEmpty()
                        ? "none"
                        : found.keySet().stream()
                                .map(victim -> "no. " + victim + (helped.contains(victim) ? " (helped)" : ""))
                                .collect(Collectors.joining(", ")));
    }
}
