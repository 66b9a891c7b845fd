package rsal.agents.pursuit;

import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import rsal.agent.AgentContext;
import rsal.agent.Directory;
import rsal.agents.parts.Markers;
import rsal.data.Fiducials;
import rsal.data.Pose2d;
import rsal.device.Device;
import rsal.device.FiducialFinder;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Sees other robots by the markers that they wear, and tells those of its kind where.
final class MarkerSight {
    static final Parameter<String> SEES = Parameter.choice(
            "sees",
            "reports",
            List.of("reports", "fiducials"),
            "How it knows the poses of the other side: from their reports; or by markers that its own side's fiducial"
                    + " detectors see.");

    private static final Duration PERIOD = Duration.ofMillis(500); // between two words about one robot

    private final AgentContext self;
    private final FiducialFinder finder;
    private final Supplier<Optional<Pose2d>> mapFromBase;
    private final String wanted;
    private final Consumer<Sighting> onSeen;
    private final Map<String, Instant> due = new HashMap<>(); // by robot

    /// @param mapFromBase where its own robot is
    /// @param wanted role of the robots to look for, or id of the one; empty for all
    /// @param onSeen told at each reading of each that it sees
    /// @throws IllegalStateException when the robot has no finder of markers
    MarkerSight(
            AgentContext self,
            Robot robot,
            Supplier<Optional<Pose2d>> mapFromBase,
            String wanted,
            Consumer<Sighting> onSeen) {
        this.self = self;
        this.finder = robot.require(FiducialFinder.class);
        this.mapFromBase = mapFromBase;
        this.wanted = wanted;
        this.onSeen = onSeen;
    }

    /// Whether it is to know others by their markers.
    static boolean byMarkers(Arguments arguments) {
        return arguments.get(SEES).equals("fiducials");
    }

    /// Types of devices that it takes to know others so.
    static List<Class<? extends Device>> needs(Arguments arguments) {
        return byMarkers(arguments) ? List.of(FiducialFinder.class) : List.of();
    }

    /// How wide the finder sees [rad]; 0 before its first reading.
    double fieldOfView() {
        return finder.latest().map(reading -> reading.value().fieldOfView()).orElse(0.0);
    }

    /// How far the finder sees [m]; 0 before its first reading.
    double range() {
        return finder.latest().map(reading -> reading.value().rangeMax()).orElse(0.0);
    }

    void begin() {
        self.subscribe(finder, reading -> mapFromBase.get().ifPresent(here -> look(reading.value(), here)));
    }

    private void look(Fiducials seen, Pose2d here) {
        for (Fiducials.Fiducial fiducial : seen.fiducials()) {
            if (fiducial.id().isPresent()) {
                Markers.wearer(self.directory(), fiducial.id().getAsInt())
                        .map(agent -> sighting(agent, here.compose(fiducial.baseFromFiducial())))
                        .filter(sighting -> wanted.isEmpty() || sighting.isOf(wanted))
                        .ifPresent(this::publish);
            }
        }
    }

    private static Sighting sighting(Directory.Entry agent, Pose2d mapFromRobot) {
        return new Sighting(agent.robot(), agent.robotRole(), mapFromRobot);
    }

    private void publish(Sighting sighting) {
        Instant now = self.scheduler().instant();
        if (!now.isBefore(due.getOrDefault(sighting.robot(), now))) {
            due.put(sighting.robot(), now.plus(PERIOD));
            self.publish(Sighting.TOPIC, sighting);
        }
        onSeen.accept(sighting);
    }
}
