package rsal.testkit.fake;

import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.CarDriveContract;

class FakeCarDriveTest extends CarDriveContract {
    @Override
    protected RobotSystemProvider provider() {
        return new FakeProvider();
    }
}
