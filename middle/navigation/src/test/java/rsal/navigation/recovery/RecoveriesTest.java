package rsal.navigation.recovery;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.ServiceLoader;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rsal.data.Angles;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.navigation.avoid.Controller;
import rsal.navigation.avoid.Controller.Motion;
import rsal.navigation.avoid.DriveLimits;
import rsal.navigation.avoid.Obstacles;
import rsal.navigation.recovery.Recovery.Situation;
import rsal.navigation.recovery.Recovery.State;
import rsal.settings.Arguments;
import rsal.time.LockstepScheduler;

/// What each recovery of the installation owes, and what it does to a robot that does at once what it is told.
class RecoveriesTest {
    private static final double STEP = 0.1; // s
    private static final double SPEED = 0.1; // m/s
    private static final Duration TIME = Duration.ofSeconds(5);

    private final LockstepScheduler scheduler = new LockstepScheduler(Instant.EPOCH, Runnable::run);
    private final World world = new World();

    /// Where the robot is, and what it is asked.
    private static final class World {
        private Pose2d pose = new Pose2d(3, 2, 0);
        private Instant now = Instant.EPOCH.plusSeconds(100);
        private Obstacles obstacles = new Obstacles(5);
        private boolean stalled;
        private boolean seesBehind;
        private boolean knowsBehind = true;
        private boolean atGoal;
        private double pathHeading; // in the map [rad]
        private double withoutProgress = 7; // s
        private int tried;
        private boolean isBlocked; // so that no command is safe

        Situation situation() {
            return new Situation(
                    now,
                    pose,
                    new Motion(pose, Twist2d.STOP),
                    stalled,
                    obstacles,
                    seesBehind,
                    knowsBehind,
                    atGoal,
                    Angles.difference(pose.theta(), pathHeading),
                    1,
                    Duration.ofMillis(Math.round(withoutProgress * 1000)),
                    pose,
                    tried);
        }

        void step(Twist2d command) {
            double heading = pose.theta() + command.omega() * STEP;
            pose = new Pose2d(
                    pose.x() + command.vx() * STEP * Math.cos(heading),
                    pose.y() + command.vx() * STEP * Math.sin(heading),
                    heading);
            now = now.plusMillis(100);
        }
    }

    /// Lets everything through, or nothing.
    private final class Simple implements Controller {
        private Twist2d safe(Twist2d wanted) {
            return world.isBlocked ? Twist2d.STOP : wanted;
        }

        @Override
        public Twist2d drive(Obstacles obstacles, Target target, Motion motion) {
            return safe(Twist2d.drive(0.4, target.bearing()));
        }

        @Override
        public Twist2d turn(Obstacles obstacles, double angle, Motion motion) {
            return safe(Twist2d.drive(0, Math.clamp(2 * angle, -1, 1)));
        }

        @Override
        public Twist2d guarded(Obstacles obstacles, Twist2d wanted, Motion motion) {
            return safe(wanted);
        }

        @Override
        public void reset() {}
    }

    static Stream<RecoveryType> types() {
        return ServiceLoader.load(RecoveryType.class).stream().map(ServiceLoader.Provider::get);
    }

    private Recovery make(RecoveryType type, Map<String, ?> values) {
        return type.create(
                Arguments.of(type.parameters(), values),
                new RecoveryType.Driven(
                        Footprint.box(0.44, 0.38, new Point2d(0, 0)),
                        new DriveLimits(0.4, 1, 1, 2),
                        1.4,
                        0.2,
                        SPEED,
                        TIME,
                        new Simple(),
                        scheduler,
                        new SplittableRandom(5)));
    }

    private Recovery make(RecoveryType type) {
        return make(type, Map.of());
    }

    /// Runs a recovery to its end.
    ///
    /// @return its commands
    private List<Twist2d> run(Recovery recovery, State end) {
        recovery.begin(world.situation());
        var commands = new ArrayList<Twist2d>();
        while (recovery.state(world.situation()) == State.RUNNING) {
            assertThat(commands).as("commands of one recovery").hasSizeLessThan(1000);
            Twist2d command = recovery.command(world.situation());
            commands.add(command);
            world.step(command);
        }
        assertThat(recovery.state(world.situation())).isEqualTo(end);
        return commands;
    }

    @Test
    void thereAreSix() {
        assertThat(types().map(RecoveryType::key))
                .containsExactlyInAnyOrder("backUp", "lookAround", "multiPointTurn", "spin", "turnAround", "wait");
    }

    @ParameterizedTest
    @MethodSource("types")
    void noneBeginsWhileThereIsProgress(RecoveryType type) {
        world.withoutProgress = 1;
        if (!type.key().equals("lookAround")) { // for robots that don't know where they are
            assertThat(make(type).isDue(world.situation())).isFalse();
        }
    }

    @ParameterizedTest
    @MethodSource("types")
    void noneCommandsWhatIsNotSafe(RecoveryType type) {
        world.isBlocked = true;
        Recovery recovery = make(type);
        recovery.begin(world.situation());
        for (int i = 0; i < 100 && recovery.state(world.situation()) == State.RUNNING; i++) {
            assertThat(recovery.command(world.situation())).isEqualTo(Twist2d.STOP);
            world.step(Twist2d.STOP);
        }
    }

    @Test
    void backsUpStraightAndTurnsToThePath() {
        world.pathHeading = 1;
        List<Twist2d> commands = run(make(new BackUpRecoveryType()), State.DONE);
        long back = commands.stream().filter(c -> c.vx() == -SPEED).count();
        assertThat(back * STEP).isBetween(0.3 * TIME.toSeconds(), TIME.toSeconds() + STEP);
        assertThat(commands.subList(0, (int) back)).allMatch(c -> c.omega() == 0);
        assertThat(world.pose.x()).isCloseTo(3 - back * STEP * SPEED, within(1e-9));
        assertThat(world.pose.theta()).isCloseTo(1, within(0.2));
    }

    @Test
    void backsUpNoFurtherIntoWhatIsBehind() {
        world.pathHeading = 1;
        Recovery recovery = make(new BackUpRecoveryType());
        recovery.begin(world.situation());
        assertThat(recovery.command(world.situation())).isEqualTo(Twist2d.drive(-SPEED, 0));
        world.stalled = true;
        assertThat(recovery.command(world.situation())).isEqualTo(Twist2d.drive(0, 1));
    }

    @Test
    void backsUpAtOnceWhenItStalls() {
        world.withoutProgress = 0;
        assertThat(make(new BackUpRecoveryType()).isDue(world.situation())).isFalse();
        world.stalled = true;
        assertThat(make(new BackUpRecoveryType()).isDue(world.situation())).isTrue();
        assertThat(make(new TurnAroundRecoveryType()).isDue(world.situation())).isFalse();
    }

    @Test
    void beginsWhenItsParameterSays() {
        Recovery early = make(new BackUpRecoveryType(), Map.of("after", 2));
        world.withoutProgress = 2;
        assertThat(early.isDue(world.situation())).isFalse();
        world.withoutProgress = 2.1;
        assertThat(early.isDue(world.situation())).isTrue();
    }

    @Test
    void turnsAroundAndDrivesBackWhereItSees() {
        List<Twist2d> commands = run(make(new TurnAroundRecoveryType()), State.DONE);
        assertThat(commands).allMatch(c -> c.vx() >= 0 && c.vx() <= SPEED + 1e-9);
        assertThat(world.pose.x()).isLessThan(3 - 0.3 * SPEED * TIME.toSeconds() / 2);
        assertThat(Math.abs(world.pose.y() - 2)).isLessThan(0.15);
        assertThat(Math.abs(world.pose.theta())).as("on its way to the path").isLessThan(Math.PI - 0.8);
    }

    @Test
    void turnsAroundOnlyIfItDoesNotSeeBehind() {
        assertThat(make(new TurnAroundRecoveryType()).isDue(world.situation())).isTrue();
        world.seesBehind = true;
        assertThat(make(new TurnAroundRecoveryType()).isDue(world.situation())).isFalse();
        world.seesBehind = false;
        world.atGoal = true;
        assertThat(make(new TurnAroundRecoveryType()).isDue(world.situation())).isFalse();
    }

    @Test
    void failsWhereThereIsNoRoomToTurn() {
        world.isBlocked = true;
        assertThat(run(make(new TurnAroundRecoveryType()), State.FAILED)).hasSize(1);
        assertThat(run(make(new SpinRecoveryType()), State.FAILED)).hasSize(1);
    }

    @Test
    void endsATurnAroundAtTheGoal() {
        Recovery recovery = make(new TurnAroundRecoveryType());
        recovery.begin(world.situation());
        world.atGoal = true;
        assertThat(recovery.state(world.situation())).isEqualTo(State.DONE);
    }

    @Test
    void spinsByTheAngleThatIsSet() {
        for (double angle : new double[] {-90, 90, 270, -400}) {
            world.pose = new Pose2d(0, 0, 3);
            double turned = run(make(new SpinRecoveryType(), Map.of("angle", angle)), State.DONE).stream()
                    .mapToDouble(c -> c.omega() * STEP)
                    .sum();
            assertThat(Math.toDegrees(turned)).isCloseTo(angle, within(3.0));
        }
    }

    @Test
    void waitsAsLongAsIsSet() {
        List<Twist2d> commands = run(make(new WaitRecoveryType(), Map.of("duration", 2.5)), State.DONE);
        assertThat(commands).hasSize(25).containsOnly(Twist2d.STOP);
    }

    @Test
    void waitsAsOftenAsIsSetUntilThereIsProgress() {
        Recovery twice = make(new WaitRecoveryType(), Map.of("times", 2));
        for (int round = 0; round < 2; round++) {
            for (world.tried = 0; world.tried < 2; world.tried++) {
                assertThat(twice.isDue(world.situation())).isTrue();
                twice.begin(world.situation());
            }
            assertThat(twice.isDue(world.situation())).isFalse();
        }
    }

    @Test
    void turnsInSeveralLegsBetweenWallsOnly() {
        Recovery recovery = make(new MultiPointTurnRecoveryType());
        assertThat(recovery.isDue(world.situation())).isTrue();
        world.knowsBehind = false;
        assertThat(recovery.isDue(world.situation())).isFalse();
        world.knowsBehind = true;
        world.stalled = true;
        assertThat(recovery.isDue(world.situation())).isFalse();
        world.stalled = false;
        world.obstacles.add(1.4, 0);
        assertThat(recovery.isDue(world.situation())).as("a wall").isTrue();
        world.obstacles.keepRoom(0, 0.1); // as what may move
        assertThat(recovery.isDue(world.situation())).as("somebody").isFalse();
    }

    @Test
    void looksAroundUntilItHasAPose() {
        Recovery recovery = make(new LookAroundRecoveryType());
        recovery.begin(world.situation());
        Twist2d ahead = recovery.command(world.situation());
        assertThat(ahead.vx()).isPositive();
        world.now = world.now.plusSeconds(1000);
        assertThat(recovery.state(world.situation())).isEqualTo(State.RUNNING);
    }
}
