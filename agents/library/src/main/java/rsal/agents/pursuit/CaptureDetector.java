package rsal.agents.pursuit;

import java.time.Duration;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import rsal.agent.AgentContext;
import rsal.agent.message.PoseReport;
import rsal.agents.parts.AgentWords;
import rsal.agents.parts.TargetTracks;
import rsal.behavior.Behavior;
import rsal.behavior.LimitTurnRate;
import rsal.behavior.Percept;
import rsal.behavior.Pilot;
import rsal.behavior.SetSpeed;
import rsal.behavior.Subsumption;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.robot.LineOfSight;
import rsal.robot.Robot;
import rsal.settings.Arguments;

/// What a prey does when it believes a hunter too near, and sees nothing that stands between: it says that it
/// is caught, and spins on the spot as long as it has room.
public final class CaptureDetector {
    private static final Twist2d SPIN = Twist2d.drive(0, Math.toRadians(40));
    private static final Duration SPIN_TIME = Duration.ofSeconds(15);
    private static final Duration SEEN = Duration.ofSeconds(1); // for how long one stays where it was seen

    private final AgentContext self;
    private final Robot robot;
    private final Pilot pilot;
    private final TargetTracks hunters;
    private final String hunterName;
    private final double catchDistance;
    private final int catchers;
    private final Runnable lettingGo;
    private boolean caught;

    /// Of a prey with the parameters of [Escape].
    ///
    /// @param lettingGo lets go of the robot for good
    static CaptureDetector of(AgentContext self, Robot robot, Arguments arguments, Runnable lettingGo) {
        return new CaptureDetector(
                self,
                robot,
                arguments.get(Escape.HUNTER),
                arguments.get(Escape.CATCH_DISTANCE),
                arguments.get(Escape.CATCHERS),
                MarkerSight.byMarkers(arguments),
                lettingGo);
    }

    /// @param hunterName role of the robots that catch it, or id of the one; empty when any other robot does
    /// @param catchers how many of them have to be near at once
    /// @param byMarkers whether it is told of hunters while they are seen, not what they report
    /// @param lettingGo lets go of the robot for good
    public CaptureDetector(
            AgentContext self,
            Robot robot,
            String hunterName,
            double catchDistance,
            int catchers,
            boolean byMarkers,
            Runnable lettingGo) {
        this.self = self;
        this.robot = robot;
        this.pilot = robot.require(Pilot.class);
        this.hunters = byMarkers ? new TargetTracks(self.blackboard(), SEEN) : new TargetTracks(self.blackboard());
        this.hunterName = hunterName;
        this.catchDistance = catchDistance;
        this.catchers = catchers;
        this.lettingGo = lettingGo;
    }

    /// @param mapFromBase where the prey believes to be; empty while it does not know
    public void note(PoseReport report, Optional<Pose2d> mapFromBase) {
        if (isHunter(report)) {
            hunters.note(report);
            lookAround(mapFromBase);
        }
    }

    boolean isHunter(PoseReport report) {
        return hunterName.isEmpty() || report.isFrom(hunterName);
    }

    void lookAround(Optional<Pose2d> mapFromBase) {
        if (!caught) {
            mapFromBase.flatMap(this::nearestHunter).ifPresent(this::giveUp);
        }
    }

    /// Of those that are near enough to catch it, with nothing between; empty while they are too few.
    private Optional<Hunter> nearestHunter(Pose2d mapFromBase) {
        List<Hunter> near = hunters.of(_ -> true).entrySet().stream()
                .filter(hunter -> LineOfSight.reaches(robot, mapFromBase, hunter.getValue(), catchDistance))
                .map(hunter -> new Hunter(hunter.getKey(), mapFromBase.distanceTo(hunter.getValue())))
                .toList();
        return near.size() < catchers
                ? Optional.empty()
                : near.stream().min(Comparator.comparingDouble(Hunter::distance)); // of equals the first by id
    }

    private void giveUp(Hunter hunter) {
        caught = true;
        lettingGo.run();
        self.publish(Caught.TOPIC, new Caught(robot.id(), hunter.robot, hunter.distance));
        self.state("caught by " + hunter.robot);
        self.show("distance", AgentWords.distance(hunter.distance));
        spin();
    }

    private void spin() {
        pilot.engage(new Subsumption()
                .layer("spin", new SetSpeed(SPIN))
                .layer("limit-turn-rate", new LimitTurnRate(robot.model().footprint(), SPIN.omega()))
                .layer("stay", new Stay()));
        self.scheduler().after(SPIN_TIME, pilot::release);
    }

    /// Stands still for good once it had to: who tried again and again would come nearer to what is in the way, a
    /// little each time that a sensor sees it farther away than it is.
    private static final class Stay implements Behavior {
        private boolean stands;

        @Override
        public Twist2d act(Percept percept, Twist2d below) {
            stands |= below.equals(Twist2d.STOP);
            return stands ? Twist2d.STOP : below;
        }
    }

    private record Hunter(String robot, double distance) {}
}
