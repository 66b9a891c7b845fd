package rsal.testkit.fake;

import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.DriveBaseContract;

class FakeDriveBaseTest extends DriveBaseContract {
    @Override
    protected RobotSystemProvider provider() {
        return new FakeProvider();
    }
}
