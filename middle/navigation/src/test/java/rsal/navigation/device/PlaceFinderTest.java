package rsal.navigation.device;

import java.util.List;
import rsal.robot.DeviceDriver;
import rsal.sim.SimProvider;
import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.PlaceFinderContract;

class PlaceFinderTest extends PlaceFinderContract {
    @Override
    protected RobotSystemProvider provider() {
        return new SimProvider();
    }

    @Override
    protected List<DeviceDriver> drivers() {
        return List.of(new PlacesDriver());
    }
}
