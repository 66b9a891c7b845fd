package rsal.testkit.fake;

import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.LaserScannerContract;

class FakeLaserScannerTest extends LaserScannerContract {
    @Override
    protected RobotSystemProvider provider() {
        return new FakeProvider();
    }
}
