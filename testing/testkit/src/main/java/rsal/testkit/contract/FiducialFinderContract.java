package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Map;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import rsal.data.Fiducials;
import rsal.data.Fiducials.Fiducial;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.device.FiducialFinder;
import rsal.device.SimulationControl.Marker;
import rsal.device.SimulationControl.Thing;
import rsal.robot.RobotModel.Part;

/// What every [FiducialFinder] owes.
public abstract class FiducialFinderContract extends SensorContract<Fiducials, FiducialFinder> {
    protected FiducialFinderContract() {
        super(FiducialFinder.class, "r1/base_link");
    }

    @Override
    protected Map<String, String> parts() {
        return Map.of("fiducials", "fiducials180");
    }

    private Part.FiducialFinder part() {
        return (Part.FiducialFinder)
                java.util.Objects.requireNonNull(model().sensors().get("fiducials"));
    }

    private static Thing marker(int id, int key, Pose2d mapFromMarker) {
        Solid post = Solid.standing(new Shape.Disc(new Point2d(0, 0), 0.05), 1);
        return Thing.of("marker-" + id, mapFromMarker, post, new Rgb(0, 0, 0)).with(new Marker(id, key));
    }

    @Test
    void itsReadingsAreThoseOfTheModelsFinder() {
        Fiducials reading = reading();
        assertThat(reading.rangeMax()).isCloseTo(part().rangeMax(), within(1e-3));
        assertThat(reading.fieldOfView()).isCloseTo(part().fieldOfView(), within(1e-3));
        assertThat(reading.baseFromFinder().isNear(part().baseFromFinder(), 1e-6, 1e-6))
                .isTrue();
        assertThat(reading.fiducials()).isEmpty();
    }

    @Test
    void reportsPosesOfMarkers() {
        Pose2d baseFromNear = Pose2d.ofDegrees(1.5, 0.5, 30);
        Pose2d baseFromFar = Pose2d.ofDegrees(3, -1, -120);
        put(marker(8, 0, START.compose(baseFromFar)));
        put(marker(7, 0, START.compose(baseFromNear)));
        Fiducials reading = reading();
        assertThat(reading.fiducials())
                .extracting(Fiducial::id)
                .as("the nearest first")
                .containsExactly(OptionalInt.of(7), OptionalInt.of(8));
        assertThat(reading.fiducials().getFirst().baseFromFiducial().isNear(baseFromNear, 0.1, 0.1))
                .isTrue();
        assertThat(reading.fiducials().getLast().baseFromFiducial().isNear(baseFromFar, 0.1, 0.1))
                .isTrue();
    }

    @Test
    void farAwayItSeesThatThereIsOneButNotWhich() {
        double far = (part().rangeMax() + part().idRange()) / 2;
        put(marker(7, 0, START.compose(new Pose2d(far, 0, 0))));
        assertThat(reading().fiducials()).extracting(Fiducial::id).containsExactly(OptionalInt.empty());
        simulation().place("marker-7", START.compose(new Pose2d(part().rangeMax() + 1, 0, 0)));
        assertThat(reading().fiducials()).isEmpty();
    }

    @Test
    void seesNothingBehindItBehindWallsOrOfAnotherKey() {
        put(marker(1, 0, START.compose(new Pose2d(-1.5, 0, 0))));
        put(marker(2, part().key() + 1, START.compose(new Pose2d(1.5, 0, 0))));
        assertThat(reading().fiducials()).isEmpty();
        put(marker(3, 0, WORLD.pose('x', 0)));
        simulation()
                .place(
                        "r1",
                        new Pose2d(WORLD.place('x').x() - 2, WORLD.place('x').y(), 0));
        assertThat(reading().fiducials()).isEmpty();
    }

    @Test
    void thingsWithoutAMarkerAreNotSeen() {
        Thing post = marker(1, 0, START.compose(new Pose2d(1.5, 0, 0)));
        put(Thing.of("post", post.mapFromThing(), post.body(), post.color()));
        assertThat(reading().fiducials()).isEmpty();
    }
}
