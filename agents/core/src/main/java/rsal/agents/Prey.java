package rsal.agents;

import java.time.Duration;
import java.util.Comparator;
import java.util.Optional;
import rsal.agent.AgentContext;
import rsal.agent.message.Caught;
import rsal.agent.message.PoseReport;
import rsal.behavior.LimitTurnRate;
import rsal.behavior.Pilot;
import rsal.behavior.SetSpeed;
import rsal.behavior.Subsumption;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.robot.Robot;
import rsal.settings.Arguments;

/// One prey's part of a hunt. What it knows of its hunters are the poses they report.
final class Prey {
    private static final Twist2d SPIN = Twist2d.drive(0, Math.toRadians(40));
    private static final Duration SPIN_TIME = Duration.ofSeconds(15);

    private final AgentContext self;
    private final Robot robot;
    private final Pilot pilot;
    private final Roaming wallFollowing;
    private final Reporter reporter;
    private final Sightings hunters;
    private final String hunterName;
    private final double catchDistance;
    private boolean caught;

    Prey(AgentContext self, Robot robot, Arguments arguments) {
        this.self = self;
        this.robot = robot;
        this.pilot = robot.require(Pilot.class);
        this.wallFollowing = Roaming.alongWalls(self, robot);
        this.reporter = new Reporter(self, robot, arguments, _ -> lookAround());
        this.hunters = new Sightings(self.blackboard());
        this.hunterName = arguments.text(Escape.HUNTER.name());
        this.catchDistance = arguments.number(Escape.CATCH_DISTANCE.name());
    }

    void begin() {
        self.subscribe(PoseReport.TOPIC, message -> note(message.content()));
        wallFollowing.begin();
        reporter.begin();
    }

    private void note(PoseReport report) {
        if (hunterName.isEmpty() || report.isFrom(hunterName)) {
            hunters.note(report);
            lookAround();
        }
    }

    private void lookAround() {
        if (!caught) {
            reporter.mapFromBase()
                    .flatMap(this::nearestHunter)
                    .filter(hunter -> hunter.distance < catchDistance)
                    .ifPresent(this::giveUp);
        }
    }

    private Optional<Hunter> nearestHunter(Pose2d mapFromBase) {
        return hunters.of(_ -> true).entrySet().stream()
                .map(hunter -> new Hunter(hunter.getKey(), mapFromBase.distanceTo(hunter.getValue())))
                .min(Comparator.comparingDouble(Hunter::distance)); // of equals the first by id
    }

    private void giveUp(Hunter hunter) {
        caught = true;
        wallFollowing.end();
        self.publish(Caught.TOPIC, new Caught(robot.id(), hunter.robot, hunter.distance));
        self.state("caught by " + hunter.robot);
        self.show("distance", Words.distance(hunter.distance));
        spin();
    }

    private void spin() {
        pilot.engage(new Subsumption()
                .layer("spin", new SetSpeed(SPIN))
                .layer("limit-turn-rate", new LimitTurnRate(robot.model().footprint(), SPIN.omega())));
        self.scheduler().after(SPIN_TIME, pilot::release);
    }

    private record Hunter(String robot, double distance) {}
}
