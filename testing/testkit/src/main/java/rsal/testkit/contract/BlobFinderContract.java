package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import rsal.data.Blobs;
import rsal.data.Blobs.Blob;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.device.BlobFinder;
import rsal.device.SimulationControl.Thing;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotSpec;
import rsal.system.RobotSystem;

/// What every [BlobFinder] owes.
public abstract class BlobFinderContract extends SensorContract<Blobs, BlobFinder> {
    private static final Rgb RED = new Rgb(255, 0, 0);
    private static final Rgb BLUE = new Rgb(0, 0, 255);
    private static final double RADIUS = 0.15;

    protected BlobFinderContract() {
        super(BlobFinder.class, "r1/camera");
    }

    @Override
    protected Map<String, String> parts() {
        return Map.of("camera", "blob-camera");
    }

    private Part.BlobFinder part() {
        return (Part.BlobFinder)
                java.util.Objects.requireNonNull(model().sensors().get("camera"));
    }

    /// A round thing, seen from where the robot starts.
    private static Thing ball(String name, double x, double y, Rgb color) {
        Pose2d mapFromBall = START.compose(new Pose2d(x, y, 0));
        return Thing.of(name, mapFromBall, Solid.standing(new Shape.Disc(new Point2d(0, 0), RADIUS), 0.6), color);
    }

    private static double bearing(Blobs blobs, double x, double y) {
        return blobs.baseFromCamera().bearingTo(new Point2d(x, y));
    }

    @Test
    void itsImagesAreThoseOfTheModelsCamera() {
        Blobs blobs = reading();
        assertThat(blobs.width()).isEqualTo(part().width());
        assertThat(blobs.height()).isEqualTo(part().height());
        assertThat(blobs.fieldOfView()).isCloseTo(part().fieldOfView(), within(1e-3));
        assertThat(blobs.baseFromCamera().isNear(part().baseFromCamera(), 1e-6, 1e-6))
                .isTrue();
    }

    @Test
    void wallsAreNoBlobs() {
        assertThat(reading().blobs()).isEmpty();
    }

    @Test
    void seesThingsInTheirColorWhereTheyAre() {
        put(ball("red", 1.8, 0.6, RED));
        put(ball("blue", 1.8, -0.3, BLUE));
        Blobs blobs = reading();
        assertThat(blobs.blobs())
                .extracting(Blob::color)
                .as("from left to right")
                .containsExactly(RED, BLUE);
        assertRight(blobs, blobs.blobs().getFirst(), 1.8, 0.6);
        assertRight(blobs, blobs.blobs().getLast(), 1.8, -0.3);
    }

    private void assertRight(Blobs blobs, Blob blob, double x, double y) {
        double column = blobs.fieldOfView() / blobs.width();
        assertThat(blobs.bearing(blob)).isCloseTo(bearing(blobs, x, y), within(1.5 * column));
        double distance = blobs.baseFromCamera().position().distanceTo(new Point2d(x, y));
        double width = 2 * Math.asin(RADIUS / distance) / column;
        assertThat((double) (blob.right() - blob.left())).isCloseTo(width, within(2.5));
        assertThat(blob.x()).isBetween((double) blob.left(), (double) blob.right());
        assertThat(blob.y()).isBetween((double) blob.top(), (double) blob.bottom());
        assertThat(blob.area()).isBetween(1, (blob.right() - blob.left()) * (blob.bottom() - blob.top()));
        assertThat(blob.left()).isBetween(0, blob.right() - 1);
        assertThat(blob.right()).isLessThanOrEqualTo(blobs.width());
        assertThat(blob.top()).isBetween(0, blob.bottom() - 1);
        assertThat(blob.bottom()).isLessThanOrEqualTo(blobs.height());
        if (!Double.isNaN(blob.range())) {
            assertThat(blob.range()).isBetween(distance - RADIUS - 0.05, distance + 0.05);
            assertThat(blobs.baseFromBlob(blob).orElseThrow().distanceTo(new Point2d(x, y)))
                    .isLessThan(RADIUS + 0.1);
        }
    }

    @Test
    void whatIsNearerLooksLarger() {
        put(ball("ball", 2.5, 0, RED));
        Blob far = reading().blobs().getFirst();
        simulation().place("ball", START.compose(new Pose2d(1.2, 0, 0)));
        Blob near = reading().blobs().getFirst();
        assertThat(near.area()).isGreaterThan(far.area());
        assertThat(near.right() - near.left()).isGreaterThan(far.right() - far.left());
    }

    @Test
    void seesNothingTooFarAwayBesideItsViewOrBehindAWall() {
        put(ball("far", part().rangeMax() + 1, 0, RED));
        put(ball("behind", -1.5, 0, RED));
        put(ball("beside", 0.2, 1.5, RED));
        assertThat(reading().blobs()).isEmpty();
        put(Thing.of("hidden", WORLD.pose('x', 0), ball("", 0, 0, RED).body(), RED));
        simulation()
                .place(
                        "r1",
                        new Pose2d(WORLD.place('x').x() - 2, WORLD.place('x').y(), 0));
        assertThat(reading().blobs()).isEmpty();
    }

    @Test
    void itsViewMovesWithTheRobot() {
        put(ball("ball", 1.5, 0, RED));
        assertThat(reading().blobs()).hasSize(1);
        simulation().place("r1", START.compose(new Pose2d(0, 0, Math.toRadians(20))));
        Blobs turned = reading();
        assertThat(turned.bearing(turned.blobs().getFirst())).isCloseTo(Math.toRadians(-20), within(0.06));
        simulation().remove("ball");
        assertThat(reading().blobs()).isEmpty();
    }

    @Test
    void seesOnlyTheColorsThatItLooksFor() {
        needs(Capability.THINGS);
        RobotModel model = model();
        Part.BlobFinder any = part();
        var blueOnly = new Part.BlobFinder(
                any.name(),
                any.baseFromCamera(),
                any.width(),
                any.height(),
                any.fieldOfView(),
                any.rangeMax(),
                List.of(BLUE),
                any.period());
        var spec = spec("r1", START);
        try (RobotSystem system = create(
                List.of(new RobotSpec(
                        spec.id(),
                        spec.role(),
                        new RobotModel(
                                model.name(), model.title(), model.body(), model.drive(), Map.of("camera", blueOnly)),
                        spec.mapFromBase(),
                        spec.color())),
                7)) {
            var camera = await(system.discover()).getFirst().require(BlobFinder.class);
            system.simulation().orElseThrow().add(ball("red", 1.8, 0.6, RED));
            system.simulation().orElseThrow().add(ball("blue", 1.8, -0.3, BLUE));
            advance(1);
            assertThat(camera.latest().orElseThrow().value().blobs())
                    .extracting(Blob::color)
                    .containsExactly(BLUE);
        }
    }
}
