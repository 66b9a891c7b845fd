package rsal.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static rsal.sim.SimRun.robot;
import static rsal.sim.SimThings.RED;
import static rsal.sim.SimThings.can;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.concurrent.Executor;
import java.util.concurrent.Executors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.ActuatorState;
import rsal.data.ActuatorState.Joint;
import rsal.data.ActuatorState.Motion;
import rsal.data.BatteryState;
import rsal.data.BatteryState.Charging;
import rsal.data.Blobs;
import rsal.data.Blobs.Blob;
import rsal.data.Interval;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.data.Twist2d;
import rsal.device.Actuator;
import rsal.device.Battery;
import rsal.device.BlobFinder;
import rsal.device.Gripper;
import rsal.device.LaserScanner;
import rsal.device.Sensor;
import rsal.device.SimulationControl.Thing;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotSpec;
import rsal.scene.Entity;
import rsal.scene.Surface;

class SimPartsTest {
    private static final Duration PERIOD = Duration.ofMillis(100);

    private static Part.BlobFinder camera(Rgb... colors) {
        return new Part.BlobFinder(
                "camera", Pose2d.ORIGIN, 80, 60, Math.toRadians(80), 5, List.of(colors), PERIOD); // 1° each way
    }

    private static RobotModel with(Part part, double height) {
        RobotModel box = Models.box(Models.DRIVE, part);
        return new RobotModel("box", "Box", box.body(), box.drive(), box.sensors(), Map.of(part.name(), height));
    }

    private static List<Blob> blobs(SimRun run) {
        run.advance(0.1);
        Blobs blobs =
                run.robot("r1").require(BlobFinder.class).latest().orElseThrow().value();
        return blobs.blobs();
    }

    private static SimRun looking(double height, List<Entity> things, Rgb... colors) {
        return SimRun.of(SimRun.room(8, 4), things, robot("r1", with(camera(colors), height), new Pose2d(2, 2, 0)));
    }

    @Test
    void aBlobIsAsHighAsWhatItShows() {
        var run = looking(0.5, List.of());
        run.simulation.add(can("can", 4, 2, 0.1, 0.8));
        Blob blob = blobs(run).getFirst();
        double up = Math.toDegrees(Math.atan(0.3 / 1.9)); // to what is 0.3 m above the camera
        double down = Math.toDegrees(Math.atan(0.5 / 1.9));
        assertThat(blob.top()).isEqualTo((int) Math.round(30 - up));
        assertThat(blob.bottom()).isEqualTo((int) Math.round(30 + down));
        double half = Math.toDegrees(Math.asin(0.1 / 2));
        assertThat(blob.left()).isEqualTo((int) Math.round(40 - half));
        assertThat(blob.right()).isEqualTo((int) Math.round(40 + half));
        assertThat(blob.range()).isBetween(1.9, 1.95);
    }

    @Test
    void whatIsHigherShowsAboveWhatIsNearer() {
        var run = looking(0.1, List.of());
        run.simulation.add(Thing.of(
                "puck",
                new Pose2d(2.5, 2, 0),
                Solid.standing(new Shape.Disc(new Point2d(0, 0), 0.05), 0.1),
                new Rgb(0, 0, 255)));
        run.simulation.add(can("box", 5, 2, 0.2, 0.6));
        assertThat(blobs(run)).extracting(Blob::color).containsExactlyInAnyOrder(new Rgb(0, 0, 255), RED);
        run.simulation.place("puck", new Pose2d(3.5, 2, 0)); // now it hides a notch of the box
        assertThat(blobs(run)).extracting(Blob::color).containsExactly(RED, new Rgb(0, 0, 255));
        Blob box = blobs(run).getFirst();
        assertThat(box.area()).isLessThan((box.right() - box.left()) * (box.bottom() - box.top()));
        assertThat(box.range()).isBetween(2.75, 2.9);
    }

    @Test
    void whatIsBelowTheImageHidesNothing() {
        var run = looking(0.5, List.of());
        run.simulation.add(can("plate", 2, 2, 0.4, 0.02));
        run.simulation.add(can("can", 4, 2, 0.1, 0.8));
        assertThat(blobs(run))
                .hasSize(1)
                .first()
                .extracting(Blob::range)
                .satisfies(r -> assertThat((double) r).isGreaterThan(1.8));
    }

    @Test
    void oneColorIsOneBlobAndAnotherInFrontMakesItTwo() {
        var run = looking(0.1, List.of());
        run.simulation.add(can("left", 5, 2.3, 0.4, 0.5));
        run.simulation.add(can("right", 5, 1.7, 0.4, 0.5));
        assertThat(blobs(run)).hasSize(1);
        var front = can("front", 3.5, 2, 0.1, 0.5);
        run.simulation.add(new rsal.device.SimulationControl.Thing(
                front.name(), front.mapFromThing(), front.body(), new Rgb(0, 0, 255), false, false, front.marker(), 0));
        assertThat(blobs(run)).extracting(Blob::color).containsExactly(RED, new Rgb(0, 0, 255), RED);
    }

    @Test
    void whatIsNoBlobIsNotReportedAndHidesWhatIsBehindIt() {
        var thing = can("screen", 3, 2, 0.3, 0.5);
        var blocks = Entity.blocks(thing.body(), RED).stream()
                .map(block -> new rsal.scene.Block(
                        block.prism(), Surface.PLAIN.in(RED).withoutBlobs()))
                .toList();
        var run = looking(0.1, List.of(new Entity("screen", blocks, thing.mapFromThing(), 0)));
        run.simulation.add(can("can", 5, 2, 0.1, 0.5));
        assertThat(blobs(run)).isEmpty();
        run.simulation.place("screen", new Pose2d(3, 3.5, 0));
        assertThat(blobs(run)).hasSize(1);
    }

    @Test
    void robotsAreSeenInTheirColor() {
        var green = new RobotSpec("r2", "robot", Models.box(), java.util.Optional.of(new Pose2d(4, 2, 0)), "#00ff00");
        var run = SimRun.of(SimRun.room(8, 4), robot("r1", with(camera(), 0.1), new Pose2d(2, 2, 0)), green);
        assertThat(blobs(run)).extracting(Blob::color).containsExactly(new Rgb(0, 255, 0));
    }

    @Test
    void aLaserLooksAtItsOwnHeight() {
        Part.Laser laser = Models.laser(0, PERIOD);
        for (double height : new double[] {0.1, 0.25}) {
            var run = SimRun.of(SimRun.room(8, 4), robot("r1", with(laser, height), new Pose2d(2, 2, 0)));
            run.simulation.add(can("low", 4, 2, 0.1, 0.2));
            run.advance(0.1);
            float ahead = run.robot("r1")
                    .require(LaserScanner.class)
                    .latest()
                    .orElseThrow()
                    .value()
                    .ranges()[90];
            assertThat(ahead).isCloseTo(height < 0.2 ? 1.8f : 5.8f, within(1e-5f));
        }
    }

    @Test
    void aLaserWithoutAHeightLooksAtHalfTheHeightOfTheBody() {
        var run = SimRun.of(SimRun.room(8, 4), robot("r1", Models.box(), new Pose2d(2, 2, 0))); // 0.25 m high
        run.simulation.add(can("low", 4, 2, 0.1, 0.12));
        run.advance(0.1);
        LaserScanner laser = run.robot("r1").require(LaserScanner.class);
        assertThat(laser.latest().orElseThrow().value().ranges()[90]).isCloseTo(5.8f, within(1e-5f));
        run.simulation.add(can("tall", 3, 2, 0.1, 0.13));
        run.advance(0.1);
        assertThat(laser.latest().orElseThrow().value().ranges()[90]).isCloseTo(0.8f, within(1e-5f));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.01, 0.07, 0.2})
    void aJointNeverLeavesItsLimitsNorIsTooFast(double step) {
        var part = new Part.Actuator(
                "lift", Pose2d.ORIGIN, Joint.LINEAR, new Interval(-0.2, 0.7), 0.3, 0.1, Duration.ofMillis(10));
        var run = SimRun.of(
                SimRun.room(4, 4),
                Map.of("step", step),
                robot("r1", Models.box(Models.DRIVE, part), new Pose2d(2, 2, 0)));
        Actuator joint = run.robot("r1").require(Actuator.class);
        run.advance(step);
        var random = new SplittableRandom(5);
        var endings = new ArrayList<Actuator.Result>();
        int begun = 0;
        double before = 0.1;
        for (int i = 0; i < 2000; i++) {
            int what = random.nextInt(10);
            if (what == 0) {
                begun++;
                joint.goTo(random.nextDouble(-1, 1)).result().thenAccept(endings::add);
            } else if (what == 1) {
                joint.command(random.nextDouble(-1, 1));
            }
            run.advance(step);
            ActuatorState state = joint.latest().orElseThrow().value();
            assertThat(state.position()).isBetween(-0.2, 0.7);
            assertThat(Math.abs(state.position() - before)).isLessThanOrEqualTo(0.3 * step + 1e-12);
            assertThat(state.position() - before).isCloseTo(state.speed() * step, within(1e-12));
            before = state.position();
        }
        run.system.close();
        assertThat(endings).hasSize(begun);
    }

    @Test
    void aJointThatIsPushedBeyondItsLimitIsStalled() {
        var part = new Part.Actuator("lift", Pose2d.ORIGIN, Joint.LINEAR, new Interval(0, 1), 5, 1, PERIOD);
        var run = SimRun.of(SimRun.room(4, 4), robot("r1", Models.box(Models.DRIVE, part), new Pose2d(2, 2, 0)));
        Actuator joint = run.robot("r1").require(Actuator.class);
        joint.command(1);
        run.advance(0.2);
        assertThat(joint.latest().orElseThrow().value().motion()).isEqualTo(Motion.STALLED);
        run.advance(1);
        assertThat(joint.latest().orElseThrow().value().motion()).isEqualTo(Motion.IDLE);
    }

    private static Part.Battery battery(double charge, double idle, double charging, double giving) {
        return new Part.Battery("battery", 1000, charge, idle, 0, 0, charging, giving, PERIOD);
    }

    private static BatteryState battery(SimRun run, String id) {
        return run.robot(id).require(Battery.class).latest().orElseThrow().value();
    }

    @Test
    void robotsThatTouchShareWhatOneGives() {
        var run = SimRun.of(
                SimRun.room(8, 4),
                robot("giver", Models.box(Models.DRIVE, battery(900, 0, 0, 30)), new Pose2d(2, 2, 0)),
                robot("taker", Models.box(Models.DRIVE, battery(0, 0, 20, 0)), new Pose2d(2.505, 2, 0)),
                robot("third", Models.box(Models.DRIVE, battery(0, 0, 20, 0)), new Pose2d(1.495, 2, 0)));
        run.advance(10);
        assertThat(battery(run, "giver").charge()).isCloseTo(900 - 300, within(1e-6));
        assertThat(battery(run, "taker").charge()).isCloseTo(200, within(1e-6));
        assertThat(battery(run, "third").charge()).isCloseTo(100, within(1e-6));
        assertThat(battery(run, "giver").charging()).isEqualTo(Charging.GIVING);
        assertThat(battery(run, "taker").power()).isCloseTo(20, within(1e-6));
        run.simulation.place("taker", new Pose2d(5, 2, 0));
        run.advance(0.1);
        assertThat(battery(run, "taker").charging()).isEqualTo(Charging.DISCHARGING);
    }

    @Test
    void aStoreIsNeverFullerThanFullNorEmptierThanEmpty() {
        var run = SimRun.of(
                SimRun.room(8, 4),
                robot("full", Models.box(Models.DRIVE, battery(990, 1, 20, 0)), new Pose2d(2, 2, 0)),
                robot("empty", Models.box(Models.DRIVE, battery(10, 5, 20, 0)), new Pose2d(5, 2, 0)));
        run.simulation.add(can("station", 2, 2, 0.5, 0.02).giving(50));
        run.advance(5);
        assertThat(battery(run, "full").charge()).isEqualTo(1000);
        assertThat(battery(run, "full").charging()).isEqualTo(Charging.FULL);
        assertThat(battery(run, "empty").charge()).isZero();
        assertThat(battery(run, "empty").empty()).isTrue();
        run.base("empty").command(Twist2d.drive(0.4, 0));
        run.advance(0.5);
        assertThat(run.truth("empty").x()).isGreaterThan(5);
    }

    @Test
    void runsWithAllPartsAreTheSameOnOneWorkerOrTwo() {
        List<Object> once = journal(Runnable::run);
        try (var workers = Executors.newFixedThreadPool(2)) {
            assertThat(journal(workers)).isEqualTo(once);
        }
        assertThat(once).hasSizeGreaterThan(5000);
    }

    /// All that eight robots sense that drive about among things, grip them and see them come and go.
    private static List<Object> journal(Executor workers) {
        var specs = new ArrayList<RobotSpec>();
        for (int i = 0; i < 8; i++) {
            specs.add(SimRun.anywhere("r" + i, SimThings.pioneer()));
        }
        var run = SimRun.seeded(SimRun.room(10, 8), 5, workers, specs);
        var random = new SplittableRandom(1);
        var journal = new ArrayList<Object>();
        for (RobotSpec spec : specs) {
            run.robot(spec.id()).devices().forEach(device -> {
                if (device instanceof Sensor<?> sensor && !(device instanceof rsal.device.RangeSensor)) {
                    sensor.subscribe(journal::add);
                }
            });
        }
        for (int step = 0; step < 120; step++) {
            String name = "can-" + random.nextInt(20);
            if (!run.simulation.remove(name)) {
                var near = run.truth("r" + random.nextInt(8)).compose(new Pose2d(0.27, 0, 0));
                run.simulation.add(can(name, near.x(), near.y(), 0.05, 0.3)
                        .asGrippable()
                        .with(new rsal.device.SimulationControl.Marker(1 + step, 0)));
            }
            for (RobotSpec spec : specs) {
                run.base(spec.id()).command(Twist2d.drive(random.nextDouble(-0.3, 0.6), random.nextDouble(-1, 1)));
                Gripper gripper = run.robot(spec.id()).require(Gripper.class);
                int what = random.nextInt(20);
                if (what < 2) {
                    gripper.closeAndLift();
                } else if (what == 2) {
                    gripper.lowerAndOpen();
                }
            }
            run.advance(0.1);
        }
        run.simulation.entities().forEach(entity -> journal.add(run.truth(entity)));
        assertThat(journal).anySatisfy(o -> assertThat(o.toString()).contains("holding=true"));
        assertThat(journal).anySatisfy(o -> assertThat(o.toString()).contains("Blob[color=#ff0000"));
        return journal;
    }
}
