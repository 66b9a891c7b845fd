package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import rsal.data.Pose2d;
import rsal.data.RangeArray;
import rsal.device.SonarArray;
import rsal.robot.RobotModel.Part;
import rsal.testkit.ObviousRays;

/// What every [SonarArray] owes.
public abstract class SonarArrayContract extends SensorContract<RangeArray, SonarArray> {
    protected SonarArrayContract() {
        super(SonarArray.class, "r1/base_link");
    }

    private Part.Sonars part() {
        return (Part.Sonars) java.util.Objects.requireNonNull(model().sensors().get("sonar"));
    }

    @Test
    void itsReadingsAreThoseOfTheModelsSonars() {
        RangeArray sonars = reading();
        assertThat(sonars.count()).isEqualTo(part().baseFromSensors().size());
        for (int i = 0; i < sonars.count(); i++) { // headings may have been quaternions on their way
            Pose2d expected = part().baseFromSensors().get(i);
            assertThat(sonars.baseFromSensors().get(i).distanceTo(expected)).isLessThan(1e-9);
            assertThat(sonars.baseFromSensors().get(i).theta()).isCloseTo(expected.theta(), within(1e-9));
        }
        assertThat(sonars.fieldOfView()).isCloseTo(part().fieldOfView(), within(1e-6));
        assertThat(sonars.rangeMax()).isCloseTo(part().rangeMax(), within(1e-3));
    }

    @Test
    void measuresTheNearestThingInEachCone() {
        needs(Capability.TRUTH);
        simulation().place("r1", WORLD.pose('b', -90));
        RangeArray sonars = reading();
        var rays = new ObviousRays(WORLD.grid());
        double tolerance = 5 * part().noise().deviation() + 0.03;
        int hits = 0;
        for (int i = 0; i < sonars.count(); i++) {
            Pose2d mapFromSonar = truth().compose(sonars.baseFromSensors().get(i));
            double ahead = rays.range(mapFromSonar);
            double nearest = ahead;
            for (int ray = -100; ray <= 100; ray++) {
                double angle = sonars.fieldOfView() / 2 * ray / 100;
                nearest = Math.min(nearest, rays.range(mapFromSonar.compose(new Pose2d(0, 0, angle))));
            }
            double range = sonars.ranges()[i];
            if (sonars.isHit(i)) {
                hits++;
                assertThat(range).as("sonar %d", i).isBetween(nearest - tolerance, ahead + tolerance);
            } else {
                assertThat(range).as("sonar %d", i).isEqualTo(Double.POSITIVE_INFINITY);
                assertThat(ahead).as("sonar %d", i).isGreaterThan(sonars.rangeMax() - tolerance);
            }
        }
        assertThat(hits).isGreaterThanOrEqualTo(4);
    }
}
