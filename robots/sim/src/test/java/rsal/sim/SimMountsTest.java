package rsal.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static rsal.sim.SimRun.robot;
import static rsal.sim.SimThings.can;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.concurrent.Executor;
import java.util.concurrent.Executors;
import org.junit.jupiter.api.Test;
import rsal.data.ActuatorState.Joint;
import rsal.data.Blobs;
import rsal.data.Fiducials;
import rsal.data.Interval;
import rsal.data.LaserScan;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Prism;
import rsal.data.RangeArray;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.data.Twist2d;
import rsal.device.Actuator;
import rsal.device.BlobFinder;
import rsal.device.Bumper;
import rsal.device.Device;
import rsal.device.FiducialFinder;
import rsal.device.Gripper;
import rsal.device.LaserScanner;
import rsal.device.Sensor;
import rsal.device.SimulationControl;
import rsal.device.SimulationControl.Carried;
import rsal.device.SimulationControl.Marker;
import rsal.device.SimulationControl.Thing;
import rsal.device.SonarArray;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotModel.RangeNoise;
import rsal.robot.RobotSpec;
import rsal.robot.Shift;
import rsal.scene.Block;
import rsal.scene.Entity;
import rsal.scene.Scene;
import rsal.scene.Surface;

/// Devices that stand on actuators.
class SimMountsTest {
    private static final Duration PERIOD = Duration.ofMillis(100);
    private static final double HEIGHT = 0.3; // of sensors
    private static final List<String> SENSORS = List.of("laser", "sonar", "camera", "fiducials", "bumper");

    private static Part.Actuator joint(String name, Pose2d baseFromJoint, Joint joint, double slope, double home) {
        return new Part.Actuator(name, baseFromJoint, joint, slope, new Interval(-3, 3), 100, home, PERIOD);
    }

    private static Part.Laser laser(Pose2d baseFromLaser) {
        return new Part.Laser(
                "laser", baseFromLaser, -Math.PI / 2, Math.PI / 60, 61, 0.05, 9, RangeNoise.of(0), PERIOD);
    }

    /// Sensors of every kind, moved along.
    private static Map<String, Part> sensors(Shift shift) {
        var sensors = new LinkedHashMap<String, Part>();
        sensors.put("laser", laser(shift.moved(new Pose2d(0.1, 0.05, 0.3))));
        sensors.put(
                "sonar",
                new Part.Sonars(
                        "sonar",
                        List.of(shift.moved(new Pose2d(0.1, 0, 0)), shift.moved(new Pose2d(0, 0.2, 1.5))),
                        Math.toRadians(30),
                        0.1,
                        5,
                        RangeNoise.of(0),
                        PERIOD));
        sensors.put(
                "camera",
                new Part.BlobFinder(
                        "camera", shift.moved(new Pose2d(0.2, 0, -0.2)), 80, 60, 1.5, 9, List.of(), PERIOD));
        sensors.put(
                "fiducials",
                new Part.FiducialFinder("fiducials", shift.moved(new Pose2d(0, 0.1, 0.1)), 3, 9, 9, 0, false, PERIOD));
        sensors.put(
                "bumper",
                new Part.Bumper(
                        "bumper", List.of(new Part.Bumper.Pad(shift.moved(new Pose2d(0.3, 0, 0)), 0.3)), PERIOD));
        return sensors;
    }

    private static RobotModel model(Map<String, Part> parts, double height, Map<String, String> carriers) {
        RobotModel box = Models.box();
        var heights = new LinkedHashMap<String, Double>();
        parts.keySet().forEach(name -> heights.put(name, height));
        return new RobotModel("box", "Box", box.body(), box.drive(), parts, heights, carriers);
    }

    private static SimRun among(RobotModel model, long seed) {
        var random = new SplittableRandom(seed);
        var run = SimRun.of(SimRun.room(9, 7), robot("r1", model, new Pose2d(4.5, 3.5, 0.7)));
        for (int i = 0; i < 25; i++) {
            double x = random.nextDouble(0.5, 8.5);
            double y = random.nextDouble(0.5, 6.5);
            run.simulation.add(can("can-" + i, x, y, random.nextDouble(0.05, 0.3), random.nextDouble(0.1, 0.9))
                    .asObstacle()
                    .with(new Marker(i + 1, 0)));
        }
        return run;
    }

    private static <T> T reading(SimRun run, Class<? extends Sensor<T>> type) {
        return run.robot("r1").require(type).latest().orElseThrow().value();
    }

    /// What sensors on two joints tell, one on the other, is what those tell that stand there for good.
    @Test
    void whatIsCarriedSensesFromWhereItHasBeenCarried() {
        int pressed = 0;
        int markers = 0;
        for (long seed = 0; seed < 150; seed++) {
            var random = new SplittableRandom(seed);
            var outer = joint(
                    "outer",
                    anywhere(random),
                    random.nextBoolean() ? Joint.LINEAR : Joint.ROTATIONAL,
                    0,
                    random.nextDouble(-1, 1));
            var inner = joint(
                    "inner",
                    anywhere(random),
                    Joint.LINEAR,
                    random.nextBoolean() ? 0 : random.nextDouble(-0.3, 0.3),
                    random.nextDouble(-1, 1));
            double outerAt = random.nextDouble(-1, 1);
            double innerAt = random.nextDouble(-0.5, 0.5);
            var carried = sensors(Shift.NONE);
            carried.put("inner", inner);
            carried.put("outer", outer);
            var carriers = new LinkedHashMap<>(Map.of("inner", "outer"));
            SENSORS.forEach(sensor -> carriers.put(sensor, "inner"));
            Shift shift = outer.shift(outerAt).compose(inner.shift(innerAt));

            SimRun moving = among(model(carried, HEIGHT, carriers), seed);
            SimRun standing = among(model(sensors(shift), HEIGHT + shift.rise(), Map.of()), seed);
            actuator(moving, "outer").goTo(outerAt);
            actuator(moving, "inner").goTo(innerAt);
            moving.advance(0.2);
            standing.advance(0.2);

            LaserScan scan = reading(moving, LaserScanner.class);
            LaserScan expected = reading(standing, LaserScanner.class);
            assertNear(scan.baseFromLaser(), expected.baseFromLaser());
            assertThat(scan.ranges()).as("seed %d", seed).containsExactly(expected.ranges(), within(1e-5f));
            RangeArray sonar = reading(moving, SonarArray.class);
            assertThat(sonar.ranges())
                    .containsExactly(reading(standing, SonarArray.class).ranges(), within(1e-5f));
            assertNear(
                    sonar.baseFromSensors().get(1),
                    reading(standing, SonarArray.class).baseFromSensors().get(1));
            Blobs blobs = reading(moving, BlobFinder.class);
            assertThat(blobs.blobs())
                    .hasSameSizeAs(reading(standing, BlobFinder.class).blobs());
            assertNear(
                    blobs.baseFromCamera(), reading(standing, BlobFinder.class).baseFromCamera());
            Fiducials found = reading(moving, FiducialFinder.class);
            Fiducials others = reading(standing, FiducialFinder.class);
            assertNear(found.baseFromFinder(), others.baseFromFinder());
            assertThat(found.fiducials()).hasSameSizeAs(others.fiducials());
            for (int i = 0; i < found.fiducials().size(); i++) {
                assertThat(found.fiducials().get(i).id())
                        .isEqualTo(others.fiducials().get(i).id());
                assertNear(
                        found.fiducials().get(i).baseFromFiducial(),
                        others.fiducials().get(i).baseFromFiducial());
            }
            markers += found.fiducials().size();
            var touch = reading(moving, Bumper.class);
            assertThat(touch.pressed())
                    .isEqualTo(reading(standing, Bumper.class).pressed());
            assertNear(
                    touch.baseFromBumpers().getFirst(),
                    reading(standing, Bumper.class).baseFromBumpers().getFirst());
            pressed += touch.pressed().contains(true) ? 1 : 0;
        }
        assertThat(pressed).isPositive();
        assertThat(markers).isPositive();
    }

    private static Pose2d anywhere(SplittableRandom random) {
        return new Pose2d(random.nextDouble(-0.5, 0.5), random.nextDouble(-0.5, 0.5), random.nextDouble(-3, 3));
    }

    private static Actuator actuator(SimRun run, String name) {
        return (Actuator) device(run, name);
    }

    private static Device device(SimRun run, String name) {
        return run.robot("r1").devices().stream()
                .filter(device -> device.info().name().equals(name))
                .findFirst()
                .orElseThrow();
    }

    private static void assertNear(Pose2d actual, Pose2d expected) {
        assertThat(actual.isNear(expected, 1e-6, 1e-6))
                .as("%s, %s", actual, expected)
                .isTrue();
    }

    private static final Part.Actuator ARM = new Part.Actuator(
            "arm", new Pose2d(0.2, 0, 0), Joint.ROTATIONAL, new Interval(-Math.PI, Math.PI), 1, 0, PERIOD);

    private static Block bar(double from, double to, double bottom) {
        var corners = List.of(
                new Point2d(from, -0.05), new Point2d(to, -0.05), new Point2d(to, 0.05), new Point2d(from, 0.05));
        var prism = new Prism(new Shape.Polygon(corners), bottom, bottom + 0.1, Optional.empty());
        return new Block(prism, Surface.PLAIN, Optional.of("arm"));
    }

    /// A box of 0.5 m × 0.4 m with an arm that reaches from x = 0.2 to 1.
    private static SimRun withArm(Part.Actuator arm, double bottom, RobotSpec... others) {
        RobotModel box = Models.box();
        var parts = Map.<String, Part>of("arm", arm);
        var spec = robot(
                "r1", new RobotModel("box", "Box", box.body(), box.drive(), parts, Map.of()), new Pose2d(4.5, 3.5, 0));
        var blocks = new ArrayList<>(Entity.blocks(box.body(), SimThings.RED));
        blocks.add(bar(0.2, 1, bottom));
        Scene room = Scene.of(SimRun.room(9, 7));
        var scene = new Scene(
                "",
                room.map(),
                Optional.empty(),
                Optional.empty(),
                room.touch(),
                room.walls(),
                List.of(),
                List.of(),
                Map.of("r1", new Entity("r1", blocks, new Pose2d(4.5, 3.5, 0), 0)),
                Map.of(),
                Map.of(),
                room.contents(),
                List.of(),
                List.of());
        var specs = new ArrayList<>(List.of(spec));
        specs.addAll(List.of(others));
        return SimRun.in(scene, specs.toArray(RobotSpec[]::new));
    }

    private static List<Actuator.Result> goTo(SimRun run, double position) {
        var endings = new ArrayList<Actuator.Result>();
        actuator(run, "arm").goTo(position).result().thenAccept(endings::add);
        return endings;
    }

    @Test
    void anArmSwingsUntilItTouchesSomethingAndGoesOnWhenThatIsGone() {
        var run = withArm(ARM, 0.1);
        run.simulation.add(can("can", 4.7, 4.2, 0.1, 0.5).asObstacle());
        List<Actuator.Result> endings = goTo(run, Math.PI / 2);
        run.advance(3);
        // the corner at the upper edge of the bar touches the can, 0.7 m from the joint: asin(0.15 / 0.7) before it
        double touch = Math.PI / 2 - Math.asin(0.15 / 0.7);
        assertThat(endings).singleElement().isInstanceOf(Actuator.Result.Stuck.class);
        assertThat(endings.getFirst().toString()).contains("'can' is in its way.");
        double position = actuator(run, "arm").latest().orElseThrow().value().position();
        assertThat(position).isBetween(touch - 0.005, touch);
        assertContacts(run, "can");
        run.simulation.remove("can");
        endings = goTo(run, Math.PI / 2);
        run.advance(1);
        assertThat(endings).singleElement().isEqualTo(new Actuator.Result.Reached(Math.PI / 2));
        assertThat(run.simulation.add(can("can", 4.7, 4.2, 0.1, 0.5).asObstacle()))
                .isInstanceOf(SimulationControl.Placement.Refused.class);
        assertThat(run.simulation.add(can("can", 5.3, 3.5, 0.1, 0.5).asObstacle()))
                .isInstanceOf(SimulationControl.Placement.Placed.class);
    }

    /// Each once, all of robot `r1`.
    private static void assertContacts(SimRun run, String... others) {
        assertThat(run.simulation.contacts())
                .allSatisfy(contact -> assertThat(contact.robot()).isEqualTo("r1"))
                .extracting(SimulationControl.Contact::other)
                .containsExactly(others);
    }

    @Test
    void anArmThatIsPressedAgainstAWallTouchesItOnce() {
        var run = withArm(ARM, 0.1);
        run.simulation.place("r1", new Pose2d(1, 0.5, 0));
        for (int step = 0; step < 30; step++) {
            actuator(run, "arm").command(-1);
            run.advance(0.1);
        }
        assertContacts(run, "wall");
        for (int step = 0; step < 10; step++) {
            actuator(run, "arm").command(step < 3 ? 1 : -1);
            run.advance(0.1);
        }
        assertContacts(run, "wall", "wall");
    }

    /// By 20 m/s, which is 2 m in a step.
    @Test
    void whatRisesStopsUnderTheFirstThingInItsWayHoweverFast() {
        var lift =
                new Part.Actuator("arm", Pose2d.ORIGIN, Joint.LINEAR, Math.PI / 2, new Interval(0, 3), 20, 0, PERIOD);
        var run = withArm(lift, 0.1);
        var plate = new Prism(new Shape.Disc(new Point2d(0, 0), 0.3), 0.9, 0.905, Optional.empty());
        run.simulation.add(Thing.of("shelf", new Pose2d(5.2, 3.5, 0), new Solid(List.of(plate)), SimThings.RED)
                .asObstacle());
        List<Actuator.Result> endings = goTo(run, 2.5);
        run.advance(0.3);
        assertThat(endings).singleElement().isInstanceOf(Actuator.Result.Stuck.class);
        assertThat(endings.getFirst().toString()).contains("'shelf' is in its way.");
        assertThat(actuator(run, "arm").latest().orElseThrow().value().position())
                .as("the bar is 0.2 m high")
                .isBetween(0.699, 0.7);
        for (int step = 0; step < 10; step++) {
            actuator(run, "arm").command(20);
            run.advance(0.1);
        }
        assertContacts(run, "shelf");
        run.simulation.place("shelf", new Pose2d(5.2, 5, 0));
        endings = goTo(run, 2.5);
        run.advance(0.3);
        run.simulation.place("shelf", new Pose2d(5.2, 3.5, 0));
        goTo(run, 0);
        run.advance(0.3);
        assertThat(endings).singleElement().isEqualTo(new Actuator.Result.Reached(2.5));
        assertThat(actuator(run, "arm").latest().orElseThrow().value().position())
                .as("from above, where the bar begins at 0.1 m")
                .isBetween(0.805, 0.806);
        assertContacts(run, "shelf", "shelf");
    }

    @Test
    void anArmIsInTheWayOfItsOwnRobotWhereItIs() {
        var run = withArm(ARM, 0.1);
        run.simulation.add(can("can", 6, 3.5, 0.1, 0.5).asObstacle());
        drive(run);
        assertThat(run.truth("r1").x()).as("the arm ahead").isBetween(4.895, 4.9);
        goTo(run, Math.PI / 2);
        run.simulation.place("r1", new Pose2d(4.5, 3.5, 0));
        run.advance(2);
        drive(run);
        assertThat(run.truth("r1").x()).as("the arm aside").isBetween(5.645, 5.65);
    }

    private static void drive(SimRun run) {
        for (int step = 0; step < 60; step++) {
            run.base("r1").command(Twist2d.drive(0.5, 0));
            run.advance(0.1);
        }
    }

    @Test
    void whatActuatorsHaveCarriedIsReported() {
        var run = withArm(ARM, 0.1);
        run.advance(0.1);
        assertThat(run.simulation.carried("r1")).isEmpty();
        goTo(run, Math.PI / 2);
        run.advance(2);
        List<Carried> all = run.simulation.carried("r1");
        assertThat(all).hasSize(1);
        Carried arm = all.getFirst();
        assertThat(arm.devices()).isEmpty();
        assertThat(arm.pieces()).hasSize(1);
        Prism bar = run.simulation
                .body("r1")
                .orElseThrow()
                .pieces()
                .get(arm.pieces().getFirst());
        assertThat(bar.bottom()).isEqualTo(0.1);
        assertNear(arm.baseFromMoved().compose(new Pose2d(1, 0, 0)), new Pose2d(0.2, 0.8, Math.PI / 2));
        assertThat(arm.rise()).isZero();
        run.simulation.removeRobot("r1");
        assertThat(run.simulation.carried("r1")).isEmpty();
    }

    @Test
    void whatIsRaisedPassesOverThings() {
        var lift = new Part.Actuator("arm", Pose2d.ORIGIN, Joint.LINEAR, Math.PI / 2, new Interval(0, 1), 1, 0, PERIOD);
        var run = withArm(lift, 0.1);
        run.simulation.add(can("can", 6, 3.5, 0.1, 0.3).asObstacle());
        goTo(run, 0.3);
        run.advance(1);
        drive(run);
        assertThat(run.truth("r1").x()).isBetween(5.645, 5.65);
        List<Actuator.Result> endings = goTo(run, 0);
        run.advance(1);
        assertThat(endings).singleElement().isInstanceOf(Actuator.Result.Stuck.class);
    }

    @Test
    void anotherRobotSeesTheArmWhereItIs() {
        var other = robot("r2", turret(1), new Pose2d(4.7, 6, -Math.PI / 2));
        var run = withArm(ARM, 0.25, other);
        run.advance(0.1);
        LaserScanner eye = run.robot("r2").require(LaserScanner.class);
        assertThat(eye.latest().orElseThrow().value().ranges()[30]).isGreaterThan(2.2f);
        goTo(run, Math.PI / 2);
        run.advance(2);
        assertThat(eye.latest().orElseThrow().value().ranges()[30])
                .as("6 m - 0.2 m - 3.5 m - 0.8 m")
                .isCloseTo(1.5f, within(1e-5f));
    }

    private static RobotModel turret(double speed) {
        var parts = new LinkedHashMap<String, Part>();
        parts.put("laser", laser(new Pose2d(0.2, 0, 0)));
        parts.put(
                "turntable",
                new Part.Actuator(
                        "turntable",
                        new Pose2d(-0.1, 0.1, 0),
                        Joint.ROTATIONAL,
                        new Interval(-Math.PI, Math.PI),
                        speed,
                        0,
                        PERIOD));
        return model(parts, HEIGHT, Map.of("laser", "turntable"));
    }

    /// In an empty room of 9 m × 7 m, whose walls are 0.1 m thick.
    @Test
    void aScanSaysWhereTheScannerWasWhenItWasTaken() {
        var run = SimRun.of(SimRun.room(9, 7), robot("r1", turret(1), new Pose2d(4.5, 3.5, 0)));
        var headings = new ArrayList<Double>();
        for (int step = 0; step < 40; step++) {
            run.base("r1").command(new Twist2d(0.3, 0, 0.5));
            actuator(run, "turntable").command(1);
            run.advance(0.1);
            LaserScan scan = reading(run, LaserScanner.class);
            Pose2d mapFromLaser = run.truth("r1").compose(scan.baseFromLaser());
            headings.add(scan.baseFromLaser().theta());
            for (int i = 0; i < scan.ranges().length; i++) {
                Pose2d end = mapFromLaser.compose(Pose2d.polar(scan.ranges()[i], scan.angle(i)));
                double toWall =
                        Math.min(Math.min(end.x() - 0.1, 8.9 - end.x()), Math.min(end.y() - 0.1, 6.9 - end.y()));
                assertThat(toWall).as("step %d, beam %d", step, i).isCloseTo(0, within(1e-5));
            }
        }
        assertThat(headings.get(10) - headings.get(9)).isCloseTo(0.1, within(1e-9));
    }

    @Test
    void whatAGripperHoldsGoesWithTheArmThatTheGripperStandsOn() {
        var parts = new LinkedHashMap<String, Part>();
        parts.put("gripper", SimThings.gripper());
        parts.put("arm", joint("arm", Pose2d.ORIGIN, Joint.ROTATIONAL, 0, 0));
        parts.put("lift", joint("lift", Pose2d.ORIGIN, Joint.LINEAR, Math.PI / 2, 0));
        var model = model(parts, 0, Map.of("gripper", "arm", "arm", "lift"));
        var run = SimRun.of(SimRun.room(9, 7), robot("r1", model, new Pose2d(4.5, 3.5, 0)));
        run.simulation.add(can("can", 4.9, 3.5, 0.05, 0.1).asGrippable());
        var gripper = (Gripper) device(run, "gripper");
        gripper.close();
        run.advance(3);
        assertThat(gripper.latest().orElseThrow().value().holding()).isTrue();
        actuator(run, "arm").goTo(Math.PI / 2);
        actuator(run, "lift").goTo(0.5);
        run.advance(0.2);
        assertNear(run.truth("can"), new Pose2d(4.5, 3.9, Math.PI / 2));
        assertThat(height(run, "can")).isCloseTo(0.5, within(1e-9));
        assertThat(run.simulation.carried("r1"))
                .extracting(Carried::devices)
                .containsExactlyInAnyOrder(List.of("arm"), List.of("gripper"));
        actuator(run, "lift").goTo(0.1);
        gripper.open();
        run.advance(3);
        assertThat(gripper.latest().orElseThrow().value().holding()).isFalse();
    }

    private static double height(SimRun run, String thing) {
        return run.simulation.things().stream()
                .filter(standing -> standing.name().equals(thing))
                .findFirst()
                .orElseThrow()
                .height();
    }

    @Test
    void runsWithTurretsAreTheSameOnOneWorkerOrTwo() {
        List<Object> once = journal(Runnable::run);
        try (var workers = Executors.newFixedThreadPool(2)) {
            assertThat(journal(workers)).isEqualTo(once);
        }
        assertThat(once).hasSize(40 * 50);
    }

    private static List<Object> journal(Executor workers) {
        var specs = new ArrayList<RobotSpec>();
        for (int i = 0; i < 40; i++) {
            specs.add(SimRun.anywhere("r%02d".formatted(i), turret(2)));
        }
        var run = SimRun.seeded(SimRun.room(20, 20), 5, workers, specs);
        var journal = new ArrayList<Object>();
        run.robots.forEach(robot -> robot.require(LaserScanner.class)
                .subscribe(scan -> journal.add(List.of(
                        scan.time(),
                        scan.value().baseFromLaser(),
                        java.util.Arrays.hashCode(scan.value().ranges())))));
        var random = new SplittableRandom(1);
        for (int step = 0; step < 50; step++) {
            for (RobotSpec spec : specs) {
                run.base(spec.id()).command(Twist2d.drive(random.nextDouble(-0.3, 0.6), random.nextDouble(-1, 1)));
                run.robot(spec.id()).require(Actuator.class).command(random.nextDouble(-2, 2));
            }
            run.advance(0.1);
        }
        return journal;
    }
}
