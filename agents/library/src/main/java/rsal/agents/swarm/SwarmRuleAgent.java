package rsal.agents.swarm;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;
import rsal.agent.Interest;
import rsal.agent.Message;
import rsal.agent.message.PoseReport;
import rsal.agents.formation.FormationSlots;
import rsal.agents.parts.AgentTypeBase;
import rsal.agents.parts.Markers;
import rsal.agents.parts.PoseReporter;
import rsal.agents.parts.RequiredRobot;
import rsal.behavior.Behavior;
import rsal.behavior.Percept;
import rsal.behavior.Pilot;
import rsal.behavior.PioneerStack;
import rsal.behavior.Surroundings;
import rsal.data.Angles;
import rsal.data.Fiducials;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.Device;
import rsal.device.FiducialFinder;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.settings.PluginChoice;
import rsal.settings.PluginKind;

/// Drives by a rule about its neighbors, which it sees or which report their poses. There is no leader. The layers of
/// [PioneerStack#safe] keep it off walls and other robots.
public final class SwarmRuleAgent extends AgentTypeBase {
    static final Parameter<PluginChoice> RULE = Parameter.plugin(
            "rule",
            "flocking",
            PluginKind.of("swarmRule", SwarmRuleType.class, ServiceLoader.load(SwarmRuleType.class)),
            "decides where the robot drives");
    static final Parameter<Double> RADIUS = Parameter.number(
            "radius", 4, 0, 10_000, "m", "Robots within this distance are its neighbors; 0: all robots are.");
    static final Parameter<Double> SPEED =
            Parameter.number("speed", 0.3, 0.02, 3, "m/s", "Speed at which it drives at most.");

    static final Parameter<String> SEES = Parameter.choice(
            "sees",
            "reports",
            List.of("reports", "fiducials"),
            "How it knows its neighbors: from their reports of poses, or by markers that its fiducial detector sees.");

    private static final Duration DECIDE = Duration.ofMillis(200);
    private static final Duration MEMORY = Duration.ofMillis(2500); // of a neighbor's pose
    private static final Duration SLOTS = Duration.ofMillis(600);
    private static final double NOTHING = 1000; // m, to the nearest thing when there is none
    private static final double TURNING = 1.5; // rad/s for each radian of error

    public SwarmRuleAgent() {
        super(
                "neighbors",
                "Drives by a rule about its neighbors: flocking, aggregation, dispersion, formation. There is no"
                        + " leader.",
                List.of(RULE, RADIUS, SPEED, SEES, PoseReporter.PERIOD),
                List.of(Pilot.class));
    }

    @Override
    protected List<Class<? extends Device>> needsBesides(Arguments arguments) {
        return seesMarkers(arguments) ? List.of(FiducialFinder.class) : List.of();
    }

    private static boolean seesMarkers(Arguments arguments) {
        return arguments.get(SEES).equals("fiducials");
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        new Member(self, arguments).begin();
    }

    private static final class Member implements Behavior {
        private final AgentContext self;
        private final Robot robot;
        private final Pilot pilot;
        private final PoseReporter reporter;
        private final SwarmRule rule;
        private final String key;
        private final boolean markers;
        private final double radius;
        private final double speed;
        private final Instant start;
        private final SortedMap<String, Heard> heard = new TreeMap<>(); // by robot
        private Point2d mapFromVelocity = SwarmRule.STAND;
        private Instant slotsDue = Instant.MIN;
        private @Nullable Surroundings surroundings; // newest
        private int shown = -1;

        private record Heard(Pose2d mapFromBase, Instant time) {}

        Member(AgentContext self, Arguments arguments) {
            this.self = self;
            this.robot = RequiredRobot.of(self);
            this.pilot = robot.require(Pilot.class);
            this.reporter = new PoseReporter(self, robot, arguments, _ -> {});
            PluginChoice choice = arguments.get(RULE);
            this.rule = choice.as(SwarmRuleType.class).create(choice.arguments());
            this.key = choice.plugin().key();
            this.markers = seesMarkers(arguments);
            this.radius = arguments.get(RADIUS);
            this.speed = arguments.get(SPEED);
            this.start = self.scheduler().instant();
        }

        void begin() {
            if (markers) {
                self.subscribe(
                        robot.require(FiducialFinder.class),
                        reading -> reporter.mapFromBase().ifPresent(here -> see(reading.value(), here)));
            } else {
                Interest<PoseReport> interest =
                        radius == 0 ? Interest.all() : PoseReport.within(radius, reporter::mapFromBase);
                self.subscribe(PoseReport.TOPIC, interest, this::hear);
                reporter.begin();
            }
            self.scheduler().every(DECIDE, this::decide);
            pilot.engage(PioneerStack.safe(robot.model(), key, this));
            self.atEnd(pilot::release);
            self.state(key);
        }

        private void hear(Message<PoseReport> message) {
            PoseReport report = message.content();
            if (!report.robot().equals(robot.id())) {
                heard.put(report.robot(), new Heard(report.mapFromBase(), message.time()));
            }
        }

        /// By its own estimate of its pose, whose errors do not matter then: all neighbors are off by the same.
        private void see(Fiducials seen, Pose2d mapFromBase) {
            Instant now = self.scheduler().instant();
            for (Fiducials.Fiducial fiducial : seen.fiducials()) {
                if (fiducial.id().isPresent()) {
                    Markers.wearer(self.directory(), fiducial.id().getAsInt())
                            .ifPresent(agent -> heard.put(
                                    agent.robot(), new Heard(mapFromBase.compose(fiducial.baseFromFiducial()), now)));
                }
            }
        }

        private void decide() {
            Optional<Pose2d> here = reporter.mapFromBase();
            Instant now = self.scheduler().instant();
            heard.values().removeIf(one -> one.time.plus(MEMORY).isBefore(now));
            if (here.isEmpty()) {
                mapFromVelocity = SwarmRule.STAND;
                return;
            }
            var neighbors = new ArrayList<SwarmView.Neighbor>();
            heard.forEach((id, one) -> {
                if (radius == 0 || here.get().distanceTo(one.mapFromBase) <= radius) {
                    neighbors.add(new SwarmView.Neighbor(id, one.mapFromBase));
                }
            });
            double time = Duration.between(start, now).toMillis() / 1000.0;
            Point2d wanted = rule.velocity(new SwarmView(
                    time, robot.id(), here.get(), speed, neighbors, mapFromObstacle(here.get()), self.random()));
            mapFromVelocity = Vectors.atMost(wanted, speed);
            if (!now.isBefore(slotsDue)) {
                slotsDue = now.plus(SLOTS);
                rule.slots().ifPresent(slots -> self.publish(FormationSlots.TOPIC, slots));
            }
            if (neighbors.size() != shown) {
                shown = neighbors.size();
                self.show("neighbors", String.valueOf(shown));
            }
        }

        /// From the robot to the nearest thing that its sensors see, in the map frame.
        private Point2d mapFromObstacle(Pose2d mapFromBase) {
            double least = NOTHING;
            double bearing = 0;
            Surroundings seen = surroundings;
            if (seen != null) {
                for (int sector = 0; sector < Surroundings.SECTORS; sector++) {
                    double range = seen.range(sector);
                    if (range < least) {
                        least = range;
                        bearing = Surroundings.direction(sector);
                    }
                }
            }
            return Vectors.polar(least, mapFromBase.theta() + bearing);
        }

        /// Turns to where it should drive, and drives as far as it looks there.
        @Override
        public Twist2d act(Percept percept, Twist2d below) {
            surroundings = percept.surroundings();
            double length = Vectors.length(mapFromVelocity);
            Optional<Pose2d> here = reporter.mapFromBase();
            if (length == 0 || here.isEmpty()) {
                return Twist2d.STOP;
            }
            double error =
                    Angles.wrap(Vectors.angle(mapFromVelocity) - here.get().theta());
            return Twist2d.drive(length * Math.max(0, StrictMath.cos(error)), TURNING * error);
        }
    }
}
