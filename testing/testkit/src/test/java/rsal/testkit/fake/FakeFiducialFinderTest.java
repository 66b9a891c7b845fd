package rsal.testkit.fake;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import rsal.data.Fiducials.Fiducial;
import rsal.data.Pose2d;
import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.FiducialFinderContract;

class FakeFiducialFinderTest extends FiducialFinderContract {
    @Override
    protected RobotSystemProvider provider() {
        return new FakeProvider();
    }

    @Test
    void showsWhatATestWants() {
        var fiducial = new Fiducial(OptionalInt.of(5), new Pose2d(1, 0, 0));
        robot().require(FakeFiducialFinder.class).show(fiducial);
        assertThat(reading().fiducials()).containsExactly(fiducial);
    }
}
