package rsal.ros2.system;

import java.net.URI;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Nested;
import rsal.robot.DeviceDriver;
import rsal.ros2.rosbridge.FakeRosbridge;
import rsal.ros2.rosbridge.RosbridgeLink;
import rsal.ros2.rosbridge.RosbridgeOptions;
import rsal.ros2.rosbridge.RosbridgeOptions.Encoding;
import rsal.ros2.rosbridge.RosbridgeTransport;
import rsal.sim.SimProvider;
import rsal.system.RobotSystemProvider;
import rsal.testkit.LongTest;
import rsal.testkit.contract.BatteryContract;
import rsal.testkit.contract.BlobFinderContract;
import rsal.testkit.contract.CameraContract;
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
import rsal.testkit.fake.FakeLocalizer;
import rsal.testkit.fake.FakeNavigator;
import rsal.testkit.fake.FakePlanner;
import rsal.testkit.fake.FakeProvider;

/// Robots behind a server of rosbridge are robots like any other.
class RosbridgeContractTest {
    private static final RosbridgeOptions OPTIONS =
            new RosbridgeOptions(URI.create("ws://robot.local:9090"), Encoding.CBOR, Duration.ZERO, Optional.empty());

    private static OverRos over(RobotSystemProvider sim, DeviceDriver... computers) {
        return over(false, sim, computers);
    }

    private static OverRos over(boolean isRos1, RobotSystemProvider sim, DeviceDriver... computers) {
        return new OverRos(sim, List.of(computers), (network, scheduler) -> {
            RosbridgeTransport transport = new FakeRosbridge(network, isRos1).transport();
            return new RosbridgeLink(transport, OPTIONS, scheduler);
        });
    }

    @Nested
    class Whole extends RobotSystemContract {
        @Override
        protected RobotSystemProvider provider() {
            return over(new SimProvider());
        }
    }

    @Nested
    class Drive extends DriveBaseContract {
        @Override
        protected RobotSystemProvider provider() {
            return over(new SimProvider());
        }
    }

    @Nested
    @LongTest
    class Omnidirectional extends OmnidirectionalDriveContract {
        @Override
        protected RobotSystemProvider provider() {
            return over(new SimProvider());
        }
    }

    @Nested
    class Laser extends LaserScannerContract {
        @Override
        protected RobotSystemProvider provider() {
            return over(new SimProvider());
        }
    }

    @Nested
    @LongTest
    class Sonar extends SonarArrayContract {
        @Override
        protected RobotSystemProvider provider() {
            return over(new SimProvider());
        }
    }

    @Nested
    @LongTest
    class Battery extends BatteryContract {
        @Override
        protected RobotSystemProvider provider() {
            return over(new SimProvider());
        }
    }

    @Nested
    @LongTest
    class OwnLocalizer extends LocalizerContract {
        @Override
        protected RobotSystemProvider provider() {
            return over(new FakeProvider(), new FakeLocalizer.Driver());
        }

        @Override
        protected Map<String, String> parts() {
            return Map.of("localizer", "own-localizer");
        }
    }

    @Nested
    @LongTest
    class OwnMap extends OwnMapContract {
        @Override
        protected RobotSystemProvider provider() {
            return over(new SimProvider());
        }
    }

    @Nested
    @LongTest
    class OwnNavigator extends NavigatorContract {
        @Override
        protected RobotSystemProvider provider() {
            return over(new FakeProvider(), new FakeLocalizer.Driver(), new FakeNavigator.Driver());
        }

        @Override
        protected Map<String, String> parts() {
            return Map.of("navigator", "own-navigator");
        }
    }

    @Nested
    @LongTest
    class OwnPlanner extends PlannerContract {
        @Override
        protected RobotSystemProvider provider() {
            return over(new FakeProvider(), new FakePlanner.Driver());
        }

        @Override
        protected Map<String, String> parts() {
            return Map.of("planner", "own-planner");
        }
    }

    @Nested
    @LongTest
    class Inertial extends ImuContract {
        @Override
        protected RobotSystemProvider provider() {
            return over(new SimProvider());
        }
    }

    @Nested
    @LongTest
    class ImageCamera extends CameraContract {
        @Override
        protected RobotSystemProvider provider() {
            return over(new SimProvider());
        }
    }

    @Nested
    @LongTest
    class ClosingGripper extends GripperContract {
        @Override
        protected RobotSystemProvider provider() {
            return over(new SimProvider());
        }
    }

    @Nested
    @LongTest
    class Blobs extends BlobFinderContract {
        @Override
        protected RobotSystemProvider provider() {
            return over(new SimProvider());
        }
    }

    /// Of ROS 1.
    @Nested
    class DriveOfRos1 extends DriveBaseContract {
        @Override
        protected RobotSystemProvider provider() {
            return over(true, new SimProvider());
        }
    }

    @Nested
    @LongTest
    class LaserOfRos1 extends LaserScannerContract {
        @Override
        protected RobotSystemProvider provider() {
            return over(true, new SimProvider());
        }
    }

    @Nested
    class LocalizerOfRos1 extends LocalizerContract {
        @Override
        protected RobotSystemProvider provider() {
            return over(true, new FakeProvider(), new FakeLocalizer.Driver());
        }

        @Override
        protected Map<String, String> parts() {
            return Map.of("localizer", "own-localizer");
        }
    }
}
