package rsal.testkit.fake;

import java.util.List;
import rsal.robot.DeviceDriver;
import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.PlaceFinderContract;

class FakePlaceFinderTest extends PlaceFinderContract {
    @Override
    protected RobotSystemProvider provider() {
        return new FakeProvider();
    }

    @Override
    protected List<DeviceDriver> drivers() {
        return List.of(new FakePlaceFinder.Driver());
    }
}
