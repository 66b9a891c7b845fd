package rsal.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static rsal.sim.SimRun.robot;
import static rsal.sim.SimRun.room;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.Executor;
import java.util.concurrent.Executors;
import org.junit.jupiter.api.Test;
import rsal.data.LaserScan;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.Bumper;
import rsal.device.Device;
import rsal.device.FiducialFinder;
import rsal.device.Gripper;
import rsal.device.Health;
import rsal.device.LaserScanner;
import rsal.device.SimulationControl.Placement;
import rsal.device.SonarArray;
import rsal.device.Subscription;
import rsal.fault.Fault;
import rsal.fault.FaultInjection;
import rsal.robot.RobotModel.Part.Sonars;
import rsal.robot.RobotModel.RangeNoise;
import rsal.robot.RobotSpec;
import rsal.system.RobotSystem.Change;

/// Robot `r1` looks at a wall that is 5.9 m ahead of its middle, 5.8 m ahead of its laser.
class SimFaultsTest {
    private final SimRun run = SimRun.of(room(8, 4), robot("r1", Models.box(), new Pose2d(2, 2, 0)));

    private static FaultInjection faults(SimRun run) {
        return run.system.faults().orElseThrow();
    }

    private static Subscription begin(SimRun run, String robot, String device, Fault fault) {
        return faults(run).begin(robot, device, fault, new SplittableRandom(3));
    }

    private Subscription begin(String device, Fault fault) {
        return begin(run, "r1", device, fault);
    }

    private LaserScanner laser() {
        return run.robot("r1").require(LaserScanner.class);
    }

    /// What the beam ahead shows [m].
    private double ahead() {
        return laser().latest().orElseThrow().value().ranges()[90];
    }

    private Odometry odometry() {
        return run.base("r1").latest().orElseThrow().value();
    }

    /// Drives for 2 s and stands.
    private void drive(Twist2d velocity) {
        for (int i = 0; i < 20; i++) {
            run.base("r1").command(velocity);
            run.advance(0.1);
        }
        run.base("r1").command(Twist2d.STOP);
        run.advance(3);
    }

    @Test
    void aBiasedLaserMeasuresThatMuchMore() {
        run.advance(0.1);
        assertThat(ahead()).isCloseTo(5.8, within(1e-6));
        var biased = begin("laser", new Fault.Biased(0.1, 0));
        run.advance(0.1);
        assertThat(ahead()).isCloseTo(5.9, within(1e-6));
        biased.cancel();
        run.advance(0.1);
        assertThat(ahead()).isCloseTo(5.8, within(1e-6));
    }

    @Test
    void aNoisyLaserHasTheDeviationThatWasAskedFor() {
        begin("laser", new Fault.Noisy(0.3, 0));
        double squares = 0;
        int count = 0;
        for (int i = 0; i < 2000; i++) {
            run.advance(0.1);
            squares += (ahead() - 5.8) * (ahead() - 5.8);
            count++;
        }
        assertThat(Math.sqrt(squares / count)).isCloseTo(0.3, within(0.02));
    }

    @Test
    void aFrozenLaserLooksWellAndShowsWhatItSawBefore() {
        run.advance(0.1);
        var reported = new ArrayList<Stamped<LaserScan>>();
        var health = new ArrayList<Health>();
        laser().subscribe(reported::add);
        laser().onHealth(health::add);
        begin("laser", new Fault.Frozen());
        drive(Twist2d.drive(0.4, 0));
        assertThat(run.truth("r1").x()).isGreaterThan(2.5);
        assertThat(ahead()).isCloseTo(5.8, within(1e-6));
        assertThat(reported).hasSize(50);
        assertThat(reported.getLast().time()).isEqualTo(run.scheduler.instant());
        assertThat(health).isEmpty();
    }

    @Test
    void aDeadLaserTurnsStaleAndIsWellAgainAfterwards() {
        run.advance(0.1);
        var reported = new ArrayList<Object>();
        var health = new ArrayList<Health>();
        laser().subscribe(reported::add);
        laser().onHealth(health::add);
        var dead = begin("laser", new Fault.Dead());
        run.advance(0.2);
        assertThat(health).isEmpty(); // nobody can know yet
        run.advance(0.1);
        assertThat(health).containsExactly(new Health.Stale("No reading for 300 ms."));
        run.advance(1);
        assertThat(reported).isEmpty();
        dead.cancel();
        run.advance(0.1);
        assertThat(reported).hasSize(1);
        assertThat(laser().health()).isEqualTo(Health.ok());
    }

    @Test
    void otherSensorsDoNotNotice() {
        var noisy = Models.box(
                Models.DRIVE,
                Models.laser(0.05, Duration.ofMillis(100)),
                new Sonars(
                        "sonar",
                        Models.SONARS.baseFromSensors(),
                        0.5,
                        0.1,
                        5,
                        RangeNoise.of(0.05),
                        Duration.ofMillis(100)));
        var well = SimRun.of(room(8, 4), robot("r1", noisy, new Pose2d(2, 2, 0)));
        var broken = SimRun.of(room(8, 4), robot("r1", noisy, new Pose2d(2, 2, 0)));
        var dead = begin(broken, "r1", "sonar", new Fault.Dead());
        begin(broken, "r1", "sonar", new Fault.Noisy(0.1, 0));
        for (SimRun each : List.of(well, broken)) {
            each.advance(2);
        }
        assertThat(scan(broken)).containsExactly(scan(well));
        dead.cancel();
        for (SimRun each : List.of(well, broken)) {
            each.advance(2);
        }
        assertThat(scan(broken)).containsExactly(scan(well));
        assertThat(broken.robot("r1").require(SonarArray.class).latest()).isPresent();
    }

    private static float[] scan(SimRun run) {
        return run.robot("r1")
                .require(LaserScanner.class)
                .latest()
                .orElseThrow()
                .value()
                .ranges();
    }

    @Test
    void aRobotWithoutMotorsStandsWhateverItsCommands() {
        var dead = begin("base", new Fault.MotorDead(0));
        drive(Twist2d.drive(0.4, 0.5));
        assertThat(run.truth("r1")).isEqualTo(new Pose2d(2, 2, 0));
        assertThat(odometry()).isEqualTo(new Odometry(Pose2d.ORIGIN, Twist2d.STOP, false));
        assertThat(run.base("r1").health()).isEqualTo(Health.ok());
        dead.cancel();
        drive(Twist2d.drive(0.4, 0));
        assertThat(run.truth("r1").x()).isGreaterThan(2.5);
    }

    @Test
    void motorsThatDieOnTheWayStopAtOnce() {
        for (int i = 0; i < 20; i++) {
            run.base("r1").command(Twist2d.drive(0.4, 0));
            run.advance(0.1);
        }
        begin("base", new Fault.MotorDead(0));
        Pose2d there = run.truth("r1");
        run.advance(1);
        assertThat(run.truth("r1")).isEqualTo(there);
    }

    @Test
    void withHalfThePowerItIsHalfAsFast() {
        begin("base", new Fault.MotorDead(0.5));
        for (int i = 0; i < 20; i++) {
            run.base("r1").command(Twist2d.drive(0.4, 0.2));
            run.advance(0.1);
        }
        assertThat(odometry().velocity()).isEqualTo(Twist2d.drive(0.2, 0.1));
    }

    @Test
    void slippingOdometryCountsMoreThanTheRobotMakes() {
        var other = SimRun.of(room(8, 4), robot("r1", Models.box(), new Pose2d(2, 2, 0)));
        begin("base", new Fault.Slip(0.25, 0, 0));
        drive(Twist2d.drive(0.4, 0));
        for (int i = 0; i < 20; i++) {
            other.base("r1").command(Twist2d.drive(0.4, 0));
            other.advance(0.1);
        }
        other.base("r1").command(Twist2d.STOP);
        other.advance(3);
        assertThat(run.truth("r1")).isEqualTo(other.truth("r1"));
        double made = run.truth("r1").x() - 2;
        assertThat(odometry().odomFromBase().x()).isCloseTo(1.25 * made, within(1e-9));
    }

    @Test
    void slippingTurnsAndDrifts() {
        var slip = begin("base", new Fault.Slip(0, 0.5, 0));
        drive(Twist2d.drive(0, 0.3));
        double turned = run.truth("r1").theta();
        assertThat(odometry().odomFromBase().theta()).isCloseTo(1.5 * turned, within(1e-9));
        slip.cancel();
        begin("base", new Fault.Slip(0, 0, 0.1));
        Pose2d odometryBefore = odometry().odomFromBase();
        Pose2d before = run.truth("r1");
        drive(Twist2d.drive(0.4, 0));
        assertThat(run.truth("r1").theta()).isCloseTo(turned, within(1e-9));
        assertThat(odometry().odomFromBase().theta() - odometryBefore.theta())
                .isCloseTo(0.1 * before.distanceTo(run.truth("r1")), within(1e-9));
    }

    @Test
    void withoutOdometryTheBaseIsStaleButDrives() {
        run.advance(0.1);
        begin("base", new Fault.Dead());
        drive(Twist2d.drive(0.4, 0));
        assertThat(run.base("r1").health()).isEqualTo(new Health.Stale("No odometry for 500 ms."));
        assertThat(run.truth("r1").x()).isGreaterThan(2.5);
        assertThat(odometry().odomFromBase()).isEqualTo(Pose2d.ORIGIN);
    }

    private static SimRun two() {
        return SimRun.of(
                room(8, 4),
                robot("r1", Models.box(), new Pose2d(2, 2, 0)),
                robot("r2", Models.box(), new Pose2d(4, 2, 0)));
    }

    private static double ahead(SimRun run) {
        return scan(run)[90];
    }

    private static void drive(SimRun run, String robot, Twist2d velocity, double seconds) {
        for (int i = 0; i < seconds * 10; i++) {
            run.base(robot).command(velocity);
            run.advance(0.1);
        }
    }

    @Test
    void aRobotThatIsGoneIsNowhereAndSaysNothing() {
        var two = two();
        two.advance(0.1);
        assertThat(ahead(two)).isCloseTo(1.65, within(1e-6));
        var changes = new ArrayList<Change>();
        two.system.onChange(changes::add);
        begin(two, "r2", "", new Fault.Gone(false));
        assertThat(changes).containsExactly(new Change.Gone("r2", "It has vanished."));
        assertThat(two.robot("r2").devices()).extracting(Device::health).hasOnlyElementsOfType(Health.Lost.class);
        var reported = new ArrayList<Object>();
        two.base("r2").subscribe(reported::add);
        two.robot("r2").require(LaserScanner.class).subscribe(reported::add);
        drive(two, "r1", Twist2d.drive(0.8, 0), 5);
        assertThat(reported).isEmpty();
        assertThat(two.truth("r1").x()).isGreaterThan(4.5); // through where it was
        assertThat(two.simulation.contacts()).isEmpty();
        assertThat(ahead(two)).isCloseTo(7.8 - two.truth("r1").x(), within(1e-4));
        assertThat(two.simulation.truth("r2")).isEmpty();
        assertThat(two.simulation.entities()).containsExactly("r1");
        assertThat(two.simulation.place("r2", new Pose2d(6, 2, 0))).isInstanceOf(Placement.Refused.class);
    }

    @Test
    void itComesBackWhereItWasAsSoonAsThereIsRoom() {
        var two = two();
        var gone = begin(two, "r2", "", new Fault.Gone(false));
        drive(two, "r1", Twist2d.drive(0.8, 0), 3);
        drive(two, "r1", Twist2d.STOP, 2);
        assertThat(two.truth("r1").x()).isBetween(3.6, 4.49);
        var changes = new ArrayList<Change>();
        two.system.onChange(changes::add);
        gone.cancel();
        gone.cancel();
        two.advance(1);
        assertThat(changes).isEmpty();
        drive(two, "r1", Twist2d.drive(-0.8, 0), 3);
        assertThat(changes).singleElement().isInstanceOf(Change.Appeared.class);
        assertThat(two.truth("r2")).isEqualTo(new Pose2d(4, 2, 0));
        assertThat(two.robot("r2").devices()).extracting(Device::health).containsOnly(Health.ok());
        drive(two, "r2", Twist2d.drive(0.8, 0), 2);
        assertThat(two.truth("r2").x()).isGreaterThan(4.5);
    }

    @Test
    void oneThatStaysStandsInTheWay() {
        var two = two();
        var gone = begin(two, "r2", "", new Fault.Gone(true));
        drive(two, "r2", Twist2d.drive(0.8, 0), 1);
        drive(two, "r1", Twist2d.drive(0.8, 0), 5);
        assertThat(two.truth("r2")).isEqualTo(new Pose2d(4, 2, 0));
        assertThat(two.truth("r1").x()).isLessThan(3.51);
        assertThat(two.simulation.contacts()).hasSize(1);
        assertThat(two.robot("r2").devices()).extracting(Device::health).hasOnlyElementsOfType(Health.Lost.class);
        gone.cancel();
        two.advance(0.1);
        assertThat(two.robot("r2").devices()).extracting(Device::health).containsOnly(Health.ok());
    }

    @Test
    void goneTwiceItComesBackWhenBothAreOver() {
        var one = begin("", new Fault.Gone(false));
        var other = begin("", new Fault.Gone(true));
        one.cancel();
        run.advance(0.1);
        assertThat(run.simulation.truth("r1")).isEmpty();
        other.cancel();
        run.advance(0.1);
        assertThat(run.simulation.truth("r1")).isPresent();
    }

    @Test
    void whatItHeldStaysBehind() {
        var model = Models.box(Models.DRIVE, SimThings.gripper());
        var one = SimRun.of(room(8, 4), robot("r1", model, new Pose2d(2, 2, 0)));
        one.simulation.add(SimThings.can("can", 2.4, 2, 0.05, 0.3).asGrippable().asObstacle());
        Gripper gripper = one.robot("r1").require(Gripper.class);
        gripper.close();
        one.advance(3);
        assertThat(gripper.latest().orElseThrow().value().holding()).isTrue();
        begin(one, "r1", "", new Fault.Gone(false));
        one.advance(0.1);
        assertThat(one.truth("can").x()).isCloseTo(2.4, within(0.01));
        assertThat(one.simulation.place("can", new Pose2d(5, 2, 0))).isEqualTo(new Placement.Placed());
    }

    @Test
    void saysWhatItCanNotBreak() {
        var pioneer = SimRun.of(room(8, 4), robot("r1", SimThings.pioneer(), new Pose2d(2, 2, 0)));
        FaultInjection faults = faults(pioneer);
        String bumper = pioneer.robot("r1").require(Bumper.class).info().name();
        String fiducials =
                pioneer.robot("r1").require(FiducialFinder.class).info().name();
        assertThat(faults.refusal("r1", bumper, new Fault.Biased(1, 0))).isPresent();
        assertThat(faults.refusal("r1", bumper, new Fault.Dead())).isEmpty();
        assertThat(faults.refusal("r1", fiducials, new Fault.Biased(1, 1))).isEmpty();
        assertThat(faults.refusal("r1", "gripper", new Fault.Dead())).contains("It is not a sensor.");
        assertThat(faults.refusal("r1", "laser", new Fault.MotorDead(0))).contains("It is not a drive.");
        assertThat(faults.refusal("r1", "nose", new Fault.Dead()))
                .get()
                .asString()
                .contains("base, ");
        assertThat(faults.refusal("r9", "laser", new Fault.Dead())).contains("There is no robot 'r9'.");
        assertThatIllegalArgumentException().isThrownBy(() -> begin(pioneer, "r1", "laser", new Fault.MotorDead(0)));
    }

    @Test
    void runsWithFaultsAreTheSameOnOneWorkerOrFour() {
        List<Object> once = journal(Runnable::run);
        try (var workers = Executors.newFixedThreadPool(4)) {
            assertThat(journal(workers)).isEqualTo(once);
        }
    }

    /// What eight robots see while things go wrong, bit for bit.
    private static List<Object> journal(Executor workers) {
        var model = Models.box(Models.DRIVE, Models.laser(0.01, Duration.ofMillis(100)), Models.SONARS);
        var specs = new ArrayList<RobotSpec>();
        for (int i = 0; i < 8; i++) {
            specs.add(SimRun.anywhere("r" + i, model));
        }
        var run = SimRun.seeded(SimProviderTest.OFFICE, 5, workers, specs);
        var journal = new ArrayList<Object>();
        for (RobotSpec spec : specs) {
            run.base(spec.id()).subscribe(journal::add);
            run.robot(spec.id())
                    .require(LaserScanner.class)
                    .subscribe(scan -> journal.add(Arrays.hashCode(scan.value().ranges())));
        }
        begin(run, "r0", "laser", new Fault.Noisy(0.2, 0));
        begin(run, "r1", "laser", new Fault.Frozen());
        begin(run, "r2", "base", new Fault.Noisy(0.1, 0.1));
        var gone = begin(run, "r3", "", new Fault.Gone(false));
        for (int step = 0; step < 60; step++) {
            run.robots.forEach(each -> run.base(each.id()).command(Twist2d.drive(0.4, 0.3)));
            run.advance(0.1);
            if (step == 30) {
                gone.cancel();
            }
        }
        return journal;
    }
}
