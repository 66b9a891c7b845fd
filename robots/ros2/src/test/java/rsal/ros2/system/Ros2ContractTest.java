package rsal.ros2.system;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Nested;
import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.BatteryContract;
import rsal.testkit.contract.BlobFinderContract;
import rsal.testkit.contract.BumperContract;
import rsal.testkit.contract.CameraContract;
import rsal.testkit.contract.DockingContract;
import rsal.testkit.contract.DriveBaseContract;
import rsal.testkit.contract.GripperContract;
import rsal.testkit.contract.ImuContract;
import rsal.testkit.contract.LaserScannerContract;
import rsal.testkit.contract.LocalizerContract;
import rsal.testkit.contract.NavigatorContract;
import rsal.testkit.contract.OmnidirectionalDriveContract;
import rsal.testkit.contract.PlannerContract;
import rsal.testkit.contract.RobotSystemContract;
import rsal.testkit.contract.SonarArrayContract;
import rsal.testkit.fake.FakeDocking;
import rsal.testkit.fake.FakeLocalizer;
import rsal.testkit.fake.FakeNavigator;
import rsal.testkit.fake.FakePlanner;
import rsal.testkit.fake.FakeProvider;

/// Robots of ROS 2 are robots like any other.
class Ros2ContractTest {
    @Nested
    class Whole extends RobotSystemContract {
        @Override
        protected RobotSystemProvider provider() {
            return new OverRos();
        }
    }

    @Nested
    class Drive extends DriveBaseContract {
        @Override
        protected RobotSystemProvider provider() {
            return new OverRos();
        }
    }

    @Nested
    class Omnidirectional extends OmnidirectionalDriveContract {
        @Override
        protected RobotSystemProvider provider() {
            return new OverRos();
        }
    }

    @Nested
    class Laser extends LaserScannerContract {
        @Override
        protected RobotSystemProvider provider() {
            return new OverRos();
        }
    }

    @Nested
    class Sonar extends SonarArrayContract {
        @Override
        protected RobotSystemProvider provider() {
            return new OverRos();
        }
    }

    @Nested
    class Battery extends BatteryContract {
        @Override
        protected RobotSystemProvider provider() {
            return new OverRos();
        }
    }

    @Nested
    class OwnLocalizer extends LocalizerContract {
        @Override
        protected RobotSystemProvider provider() {
            return new OverRos(new FakeProvider(), List.of(new FakeLocalizer.Driver()));
        }

        @Override
        protected Map<String, String> parts() {
            return Map.of("localizer", "own-localizer");
        }
    }

    @Nested
    class OwnMap extends OwnMapContract {
        @Override
        protected RobotSystemProvider provider() {
            return new OverRos();
        }
    }

    @Nested
    class OwnNavigator extends NavigatorContract {
        @Override
        protected RobotSystemProvider provider() {
            return new OverRos(new FakeProvider(), List.of(new FakeLocalizer.Driver(), new FakeNavigator.Driver()));
        }

        @Override
        protected Map<String, String> parts() {
            return Map.of("navigator", "own-navigator");
        }
    }

    @Nested
    class OwnPlanner extends PlannerContract {
        @Override
        protected RobotSystemProvider provider() {
            return new OverRos(new FakeProvider(), List.of(new FakePlanner.Driver()));
        }

        @Override
        protected Map<String, String> parts() {
            return Map.of("planner", "own-planner");
        }
    }

    @Nested
    class OwnDocking extends DockingContract {
        @Override
        protected RobotSystemProvider provider() {
            return new OverRos(new FakeProvider(), List.of(new FakeDocking.Driver()));
        }

        @Override
        protected Map<String, String> parts() {
            return Map.of("dock", "own-docking");
        }
    }

    @Nested
    class Bumpers extends BumperContract {
        @Override
        protected RobotSystemProvider provider() {
            return new OverRos();
        }
    }

    @Nested
    class Inertial extends ImuContract {
        @Override
        protected RobotSystemProvider provider() {
            return new OverRos();
        }
    }

    @Nested
    class ImageCamera extends CameraContract {
        @Override
        protected RobotSystemProvider provider() {
            return new OverRos();
        }
    }

    @Nested
    class ClosingGripper extends GripperContract {
        @Override
        protected RobotSystemProvider provider() {
            return new OverRos();
        }
    }

    @Nested
    class Blobs extends BlobFinderContract {
        @Override
        protected RobotSystemProvider provider() {
            return new OverRos();
        }
    }
}
