package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Map;
import org.junit.jupiter.api.Test;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.device.SimulationControl.Thing;
import rsal.device.camera.Camera;
import rsal.device.camera.CameraImage;
import rsal.device.camera.CameraKind;
import rsal.robot.RobotModel.Part;
import rsal.settings.Arguments;

/// What every [Camera] owes.
public abstract class CameraContract extends SensorContract<CameraImage, Camera> {
    private static final Rgb RED = new Rgb(255, 0, 0);
    private static final Rgb BLUE = new Rgb(0, 0, 255);
    private static final double RADIUS = 0.2;

    protected CameraContract() {
        super(Camera.class, "r1/eyes");
    }

    @Override
    protected Map<String, String> parts() {
        return Map.of("eyes", "depth-camera");
    }

    private Part.Registered part() {
        return (Part.Registered)
                java.util.Objects.requireNonNull(model().sensors().get("eyes"));
    }

    /// A pillar, seen from where the robot starts.
    private static Thing pillar(String name, double x, double y, Rgb color) {
        Pose2d mapFromPillar = START.compose(new Pose2d(x, y, 0));
        return Thing.of(name, mapFromPillar, Solid.standing(new Shape.Disc(new Point2d(0, 0), RADIUS), 1), color);
    }

    /// The column of the image that looks there.
    private int column(CameraImage image, double x, double y) {
        Point2d there = part().baseFromDevice().inverse().transform(new Point2d(x, y));
        return (int) Math.floor(image.width() / 2.0 - image.focalLength() * there.y() / there.x());
    }

    private int horizon(CameraImage image) {
        return image.height() / 2;
    }

    @Test
    void itsImagesAreThoseOfTheModelsCamera() {
        Arguments arguments = part().arguments();
        CameraImage image = reading();
        assertThat(image.width()).isEqualTo(arguments.get(CameraKind.COLUMNS));
        assertThat(image.height()).isEqualTo(arguments.get(CameraKind.ROWS));
        assertThat(image.focalLength()).isCloseTo(CameraKind.focalLength(arguments), within(0.1));
    }

    @Test
    void seesThingsInTheirColorAndDepthWhereTheyAre() {
        put(pillar("red", 2, 0.5, RED));
        put(pillar("blue", 2.5, -0.5, BLUE));
        CameraImage image = reading();
        assertSeen(image, 2, 0.5, RED);
        assertSeen(image, 2.5, -0.5, BLUE);
    }

    private void assertSeen(CameraImage image, double x, double y, Rgb color) {
        int column = column(image, x, y);
        assertThat(image.color(column, horizon(image))).isEqualTo(color.packed());
        double depth = image.depth(column, horizon(image));
        double noise = 5 * part().arguments().get(CameraKind.DEPTH_NOISE) * x * x;
        double middle =
                part().baseFromDevice().inverse().transform(new Point2d(x, y)).x();
        assertThat(depth).isBetween(middle - RADIUS - noise - 0.01, middle + noise);
    }

    @Test
    void itsViewMovesWithTheRobot() {
        put(pillar("red", 2, 0, RED));
        assertThat(reading().color(column(reading(), 2, 0), horizon(reading()))).isEqualTo(RED.packed());
        simulation().place("r1", START.compose(new Pose2d(0, 0, Math.toRadians(90))));
        CameraImage turned = reading();
        for (int column = 0; column < turned.width(); column++) {
            assertThat(turned.color(column, horizon(turned))).isNotEqualTo(RED.packed());
        }
    }

    @Test
    void whatIsOutOfRangeHasNoDepth() {
        simulation().place("r1", START.compose(new Pose2d(0, 0, 0)));
        CameraImage image = reading();
        double range = part().arguments().get(CameraKind.RANGE);
        for (int column = 0; column < image.width(); column += 10) {
            double depth = image.depth(column, horizon(image));
            assertThat(depth == Double.POSITIVE_INFINITY || depth < 1.1 * range)
                    .as("depth %.2f m", depth)
                    .isTrue();
        }
    }
}
