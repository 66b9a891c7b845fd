package rsal.testkit.fake;

import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.OmnidirectionalDriveContract;

class FakeOmnidirectionalDriveTest extends OmnidirectionalDriveContract {
    @Override
    protected RobotSystemProvider provider() {
        return new FakeProvider();
    }
}
