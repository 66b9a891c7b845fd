package rsal.testkit.fake;

import rsal.robot.RobotSystemProvider;
import rsal.testkit.contract.CarDriveContract;

class FakeCarDriveTest extends CarDriveContract {
    @Override
    protected RobotSystemProvider provider() {
        return new FakeProvider();
    }
}
