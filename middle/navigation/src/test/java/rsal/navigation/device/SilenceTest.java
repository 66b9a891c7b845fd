package rsal.navigation.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.lang.reflect.Proxy;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.random.RandomGenerator;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.Twist2d;
import rsal.device.Health;
import rsal.device.Localizer;
import rsal.device.Navigator;
import rsal.robot.DeviceDriver;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.testkit.LongTest;
import rsal.testkit.contract.RobotBench;
import rsal.testkit.fake.FakeDriveBase;
import rsal.testkit.fake.FakeLaserScanner;
import rsal.testkit.fake.FakeSystem;
import rsal.time.LockstepScheduler;
import rsal.time.Scheduler;

/// Software devices when what they stand on fails, and when it is back.
class SilenceTest {
    private final LockstepScheduler scheduler = new LockstepScheduler();
    private final SplittableRandom seeded = new SplittableRandom(3);
    private boolean broken;
    private final FakeSystem system = FakeSystem.pioneers(scheduler, RobotBench.WORLD, RobotBench.START);
    private Robot robot = system.robots().getFirst();
    private final FakeDriveBase base = robot.require(FakeDriveBase.class);

    @BeforeEach
    void setUp() {
        system.discover();
        RandomGenerator random = () -> {
            if (broken) {
                throw new IllegalStateException("broken by a test");
            }
            return seeded.nextLong();
        };
        for (DeviceDriver driver : new DeviceDriver[] {new AmclDriver(), new NavigatorDriver()}) {
            robot = robot.with(driver.create(
                    new DeviceDriver.Context(
                            driver.key(),
                            robot,
                            RobotBench.WORLD.grid(),
                            Optional.of(RobotBench.START),
                            scheduler,
                            random),
                    Arguments.of(driver.parameters(), Map.of())));
        }
    }

    @Test
    void withoutOdometryTheLocalizerIsStaleUntilItIsBack() {
        drive(2);
        base.turn(new Health.Lost("unplugged by a test"));
        drive(6);
        assertThat(localizer().health()).isEqualTo(new Health.Stale("No odometry for more than 2 s."));
        base.turn(Health.ok());
        drive(1);
        assertThat(localizer().health()).isEqualTo(Health.ok());
    }

    @Test
    void odometryThatIsNoNumberIsSkippedAndCounted() {
        drive(2);
        Pose2d odomFromBase = base.latest().orElseThrow().value().odomFromBase();
        var reported = new ArrayList<PoseEstimate>();
        localizer().subscribe(estimate -> reported.add(estimate.value()));

        base.resetOdometry(new Pose2d(Double.NaN, 0, 0));
        scheduler.advance(Duration.ofSeconds(6));
        assertThat(reported).isEmpty();
        assertThat(localizer().health())
                .isInstanceOfSatisfying(
                        Health.Stale.class,
                        stale -> assertThat(stale.reason())
                                .matches(
                                        "No odometry for more than 2 s\\. Skipped so far: [1-9]\\d*, .*odometry.*NaN.*"));

        base.resetOdometry(odomFromBase);
        drive(2);
        assertThat(localizer().health()).isEqualTo(Health.ok());
        assertThat(reported).isNotEmpty();
        assertThat(reported.getLast().mapFromBase().distanceTo(base.mapFromBase()))
                .isLessThan(0.3);
    }

    @Test
    void aLocalizerThatSeesNothingButNonsenseSaysSoAndIsSilent() {
        drive(2);
        var laser = robot.require(FakeLaserScanner.class);
        laser.show(Float.NaN, Float.NaN);
        drive(4);
        var before = localizer().latest();
        drive(3);
        assertThat(localizer().latest()).isEqualTo(before);
        assertThat(localizer().health())
                .isInstanceOfSatisfying(
                        Health.Stale.class,
                        stale -> assertThat(stale.reason()).contains("No ranges", "Skipped", "NaN"));
    }

    @Test
    void aNavigatorDoesNotDriveByNonsense() {
        Navigator navigator = robot.require(Navigator.class);
        drive(1);
        var goal = navigator.goTo(RobotBench.WORLD.pose('a', 0));
        scheduler.advance(Duration.ofSeconds(1));
        robot.require(FakeLaserScanner.class).show(Float.NaN, Float.NaN);
        scheduler.advance(Duration.ofMillis(300));
        assertThat(navigator.health()).isInstanceOf(Health.Stale.class);
        Pose2d before = base.mapFromBase();
        scheduler.advance(Duration.ofSeconds(1));
        assertThat(base.mapFromBase().distanceTo(before)).isLessThan(1e-9);

        scheduler.advance(Duration.ofMinutes(5));
        assertThat(goal.result().toCompletableFuture())
                .as("given up at last, where it stands")
                .isCompletedWithValueMatching(ending -> ending instanceof Navigator.Result.Stuck stuck
                        && stuck.mapFromBase().distanceTo(before) < 0.2
                        && stuck.why().contains("not known any more"));
    }

    @Test
    void aBeliefThatIsNoNumberIsRefused() {
        var unknown = new Covariance2d(Double.POSITIVE_INFINITY, 0, 0, 1, 0, 1);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> localizer().relocalize(PoseEstimate.of(RobotBench.START, unknown)))
                .withMessageContaining("Infinity");
    }

    @Test
    void aFilterThatFailsIsLostAndSilentUntilItWorksAgain() {
        drive(2);
        var healths = new ArrayList<Health>();
        localizer().onHealth(healths::add);
        broken = true;
        drive(3);
        var before = localizer().latest();
        drive(3);
        assertThat(localizer().latest()).isEqualTo(before);
        assertThat(healths).singleElement().isInstanceOf(Health.Lost.class);
        broken = false;
        drive(2);
        assertThat(localizer().health()).isEqualTo(Health.ok());
        assertThat(localizer().latest().orElseThrow().value().mapFromBase().distanceTo(base.mapFromBase()))
                .isLessThan(0.3);
    }

    @Test
    void aNavigatorWithoutAGoalIsWellAgainWhenItsSensorsAre() {
        Navigator navigator = robot.require(Navigator.class);
        drive(1);
        var goal = navigator.goTo(RobotBench.WORLD.pose('a', 0));
        base.turn(new Health.Lost("unplugged by a test"));
        scheduler.advance(Duration.ofSeconds(2));
        goal.cancel();
        scheduler.advance(Duration.ofSeconds(1));
        assertThat(navigator.health()).isInstanceOf(Health.Stale.class);
        base.turn(Health.ok());
        scheduler.advance(Duration.ofSeconds(1));
        assertThat(navigator.health()).isEqualTo(Health.ok());
    }

    private Localizer mapper() {
        return mapper(scheduler);
    }

    private Localizer mapper(Scheduler scheduler) {
        var slam = new SlamDriver();
        return (Localizer) slam.create(
                new DeviceDriver.Context(
                        "mapper", robot, RobotBench.WORLD.grid(), Optional.of(RobotBench.START), scheduler, seeded),
                Arguments.of(slam.parameters(), Map.of()));
    }

    @Test
    void aMapperThatSeesNothingIsEverLessSureAndThenLost() {
        Localizer mapper = mapper();
        drive(2);
        PoseEstimate seeing = mapper.latest().orElseThrow().value();
        assertThat(seeing.quality()).isEqualTo(PoseEstimate.Quality.LOCALIZED);
        assertThat(seeing.confidence()).isGreaterThan(0.7);

        var laser = robot.require(FakeLaserScanner.class);
        laser.show(blind(laser));
        drive(5);
        PoseEstimate blind = mapper.latest().orElseThrow().value();
        assertThat(blind.covariance().positionDeviation())
                .isGreaterThan(2 * seeing.covariance().positionDeviation());
        drive(30);
        PoseEstimate lost = mapper.latest().orElseThrow().value();
        assertThat(lost.quality()).isEqualTo(PoseEstimate.Quality.LOST);
        assertThat(lost.confidence()).isLessThan(0.3);
    }

    @Test
    void aMapperLooksAtScansThatShowSomethingNew() {
        var looks = new AtomicInteger();
        Localizer mapper = mapper(counting(looks));
        drive(1);
        looks.set(0);
        drive(10, Twist2d.drive(0.3, 0));
        assertThat(looks).as("every second of 3 cm").hasValueBetween(45, 55);
        drive(10, Twist2d.drive(0, 0.3));
        looks.set(0);
        drive(10, Twist2d.drive(0, 0.3));
        assertThat(looks).as("every third of 1.7°, or every second").hasValueBetween(33, 55);
        drive(1, Twist2d.STOP);
        looks.set(0);
        drive(10, Twist2d.STOP);
        assertThat(looks).as("two a second while it stands").hasValueBetween(19, 21);

        base.resetOdometry(base.latest().orElseThrow().value().odomFromBase().compose(new Pose2d(0.1, 0, 0)));
        looks.set(0);
        drive(1, Twist2d.STOP);
        assertThat(looks).as("and at once where the wheels lead it on").hasValueBetween(2, 4);
        assertThat(mapper.latest().orElseThrow().value().mapFromBase().distanceTo(base.mapFromBase()))
                .isLessThan(0.1);

        robot.require(FakeLaserScanner.class).show(blind(robot.require(FakeLaserScanner.class)));
        drive(1, Twist2d.STOP);
        looks.set(0);
        drive(10, Twist2d.STOP);
        assertThat(looks).as("at each while none matches").hasValueBetween(95, 101);
    }

    private static float[] blind(FakeLaserScanner laser) {
        var nothing = new float[laser.latest().orElseThrow().value().count()];
        Arrays.fill(nothing, Float.POSITIVE_INFINITY);
        return nothing;
    }

    /// The test's scheduler, which counts what is computed.
    private Scheduler counting(AtomicInteger works) {
        return (Scheduler) Proxy.newProxyInstance(
                Scheduler.class.getClassLoader(), new Class<?>[] {Scheduler.class}, (_, method, arguments) -> {
                    if (method.getName().equals("compute")) {
                        works.incrementAndGet();
                    }
                    return method.invoke(scheduler, arguments);
                });
    }

    @Test
    void aMapperThatSeesNothingButNonsenseSaysSoAndIsSilent() {
        Localizer mapper = mapper();
        drive(2);
        assertThat(mapper.latest().orElseThrow().value().mapFromBase().distanceTo(base.mapFromBase()))
                .isLessThan(0.1);
        robot.require(FakeLaserScanner.class).show(1, 2, 3);
        drive(3);
        var before = mapper.latest();
        drive(3);
        assertThat(mapper.latest()).isEqualTo(before);
        assertThat(mapper.health())
                .isInstanceOfSatisfying(
                        Health.Stale.class,
                        stale -> assertThat(stale.reason()).contains("No scan", "Skipped", "3 beams"));
    }

    /// Someone turns the robot and its wheels don't: what it maps then is believed until a loop closes, which bends the
    /// map where it was turned.
    @LongTest
    @Test
    void aMapperWhoseMapIsBentSaysThatItMayBeWrong() {
        Localizer mapper = mapper();
        circle(20);
        Pose2d odomFromBase = base.latest().orElseThrow().value().odomFromBase();
        base.resetOdometry(odomFromBase.compose(new Pose2d(0, 0, 1.2)));
        circle(30);
        PoseEstimate bent = mapper.latest().orElseThrow().value();
        assertThat(bent.mapFromBase().distanceTo(base.mapFromBase())).isGreaterThan(0.3);
        assertThat(bent.quality()).isEqualTo(PoseEstimate.Quality.AMBIGUOUS);
        assertThat(bent.confidence()).isLessThan(0.6);
        assertThat(bent.hypotheses().getFirst().mapFromBase()).isEqualTo(bent.mapFromBase());

        mapper.relocalize(PoseEstimate.of(base.mapFromBase(), Covariance2d.ofDeviations(0.1, 0.1, 0.1)));
        circle(2);
        PoseEstimate anew = mapper.latest().orElseThrow().value();
        assertThat(anew.quality()).isEqualTo(PoseEstimate.Quality.LOCALIZED);
        assertThat(anew.confidence()).isGreaterThan(0.7);
    }

    private Localizer localizer() {
        return robot.require(Localizer.class);
    }

    private void drive(int seconds) {
        drive(seconds, Twist2d.drive(0.3, 0.2));
    }

    private void circle(int seconds) {
        drive(seconds, Twist2d.drive(0.3, 0.3));
    }

    private void drive(int seconds, Twist2d velocity) {
        for (int beat = 0; beat < 10 * seconds; beat++) {
            base.command(velocity);
            scheduler.advance(Duration.ofMillis(100));
        }
    }
}
