package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.Twist2d;
import rsal.device.Localizer;

/// What every [Localizer] owes, given where the robot starts.
public abstract class LocalizerContract extends SensorContract<PoseEstimate, Localizer> {
    /// The thesis's bound [m].
    private static final double GOOD = 0.30;

    protected LocalizerContract() {
        super(Localizer.class, "map");
    }

    @Override
    protected void wake() {
        drive(Twist2d.drive(0.2, 0.1), 1); // a localizer may rest while the robot does
    }

    @Test
    void knowsWhereTheRobotStarts() {
        wake();
        assertNearTheTruth();
    }

    @Test
    void followsTheRobot() {
        for (int leg = 0; leg < 4; leg++) {
            drive(Twist2d.drive(0.4, 0), 5);
            drive(Twist2d.drive(0.1, 0.6), 2);
            assertNearTheTruth();
        }
    }

    @Test
    void startsAgainFromABelief() {
        wake();
        Pose2d wrong = new Pose2d(truth().x() + 2, truth().y() + 1, truth().theta() + 0.5);
        var belief = PoseEstimate.of(wrong, Covariance2d.ofDeviations(0.05, 0.05, 0.02));
        var done = device().relocalize(belief);
        wake();
        await(done);
        assertThat(device().latest().orElseThrow().value().mapFromBase().distanceTo(truth()))
                .isGreaterThan(1);
    }

    @Test
    void findsBackFromABeliefThatIsRight() {
        wake();
        simulation().place("r1", WORLD.pose('b', 90));
        var done = device().relocalize(PoseEstimate.of(WORLD.pose('b', 90), Covariance2d.ofDeviations(0.2, 0.2, 0.1)));
        wake();
        await(done);
        drive(Twist2d.drive(0.3, 0.3), 4);
        assertNearTheTruth();
    }

    @Test
    void itsEstimateHoldsTogether() {
        wake();
        PoseEstimate estimate = device().latest().orElseThrow().value();
        assertThat(estimate.mapFromBase().isFinite()).isTrue();
        assertThat(estimate.covariance().positionDeviation()).isBetween(0.0, 2.0);
        assertThat(estimate.covariance().thetaTheta()).isBetween(0.0, 4.0);
        assertThat(estimate.hypotheses()).isNotEmpty();
        assertThat(estimate.hypotheses().getFirst().mapFromBase()).isEqualTo(estimate.mapFromBase());
        var weights = estimate.hypotheses().stream()
                .map(PoseEstimate.Hypothesis::weight)
                .toList();
        assertThat(weights).isSortedAccordingTo((a, b) -> Double.compare(b, a));
        assertThat(weights.stream().mapToDouble(Double::doubleValue).sum()).isBetween(0.01, 1.0001);
    }

    @Test
    void itsParticlesIfItHasSomeWeighOneTogether() {
        wake();
        device().particles().ifPresent(cloud -> {
            assertThat(cloud.frame()).isEqualTo("map");
            assertThat(cloud.value().poses()).hasSize(3 * cloud.value().count());
            double sum = 0;
            for (float weight : cloud.value().weights()) {
                assertThat(weight).isNotNegative();
                sum += weight;
            }
            assertThat(sum).isCloseTo(1, within(1e-3));
        });
    }

    private void assertNearTheTruth() {
        advance(0.5);
        Pose2d believed = device().latest().orElseThrow().value().mapFromBase();
        assertThat(believed.isNear(truth(), GOOD, 0.3))
                .as("it says %s, the truth is %s", believed, truth())
                .isTrue();
    }
}
