package rsal.player;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.device.Mapper;
import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.ActuatorContract;
import rsal.testkit.contract.BatteryContract;
import rsal.testkit.contract.BlobFinderContract;
import rsal.testkit.contract.BumperContract;
import rsal.testkit.contract.Capability;
import rsal.testkit.contract.DeviceContract;
import rsal.testkit.contract.DriveBaseContract;
import rsal.testkit.contract.FiducialFinderContract;
import rsal.testkit.contract.GripperContract;
import rsal.testkit.contract.LaserScannerContract;
import rsal.testkit.contract.LocalizerContract;
import rsal.testkit.contract.NavigatorContract;
import rsal.testkit.contract.OmnidirectionalDriveContract;
import rsal.testkit.contract.RobotSystemContract;
import rsal.testkit.contract.SonarArrayContract;
import rsal.testkit.fake.FakeLocalizer;
import rsal.testkit.fake.FakeNavigator;
import rsal.testkit.fake.FakeProvider;

/// Robots of a Player server are robots like any other.
@Timeout(120)
class PlayerContractTest {
    private static final Map<String, String> OF_OLD =
            Map.of("position2d:0", "base", "laser:0", "laser", "sonar:0", "sonar");

    @Nested
    class Whole extends RobotSystemContract {
        @Override
        protected RobotSystemProvider provider() {
            return new OverTheWire();
        }

        /// Which of two servers is heard first is up to the network.
        @Override
        protected Set<Capability> cannot() {
            return Set.of(Capability.REPEATABLE);
        }
    }

    @Nested
    class Drive extends DriveBaseContract {
        @Override
        protected RobotSystemProvider provider() {
            return new OverTheWire();
        }
    }

    @Nested
    class Omnidirectional extends OmnidirectionalDriveContract {
        @Override
        protected RobotSystemProvider provider() {
            return new OverTheWire();
        }
    }

    @Nested
    class Laser extends LaserScannerContract {
        @Override
        protected RobotSystemProvider provider() {
            return new OverTheWire();
        }
    }

    @Nested
    class Sonar extends SonarArrayContract {
        @Override
        protected RobotSystemProvider provider() {
            return new OverTheWire();
        }
    }

    /// As older servers have them, and those that `rangertolaser` stands on.
    @Nested
    class LaserOfOld extends LaserScannerContract {
        @Override
        protected RobotSystemProvider provider() {
            return new OverTheWire(OF_OLD);
        }
    }

    @Nested
    class SonarOfOld extends SonarArrayContract {
        @Override
        protected RobotSystemProvider provider() {
            return new OverTheWire(OF_OLD);
        }
    }

    @Nested
    class BlobFinder extends BlobFinderContract {
        @Override
        protected RobotSystemProvider provider() {
            return new OverTheWire();
        }
    }

    @Nested
    class FiducialFinder extends FiducialFinderContract {
        @Override
        protected RobotSystemProvider provider() {
            return new OverTheWire();
        }
    }

    @Nested
    class Bumper extends BumperContract {
        @Override
        protected RobotSystemProvider provider() {
            return new OverTheWire();
        }
    }

    @Nested
    class Battery extends BatteryContract {
        @Override
        protected RobotSystemProvider provider() {
            return new OverTheWire();
        }
    }

    @Nested
    class Gripper extends GripperContract {
        @Override
        protected RobotSystemProvider provider() {
            return new OverTheWire();
        }
    }

    @Nested
    class Actuator extends ActuatorContract {
        @Override
        protected RobotSystemProvider provider() {
            return new OverTheWire();
        }
    }

    @Nested
    class OwnLocalizer extends LocalizerContract {
        @Override
        protected RobotSystemProvider provider() {
            return new OverTheWire(new FakeProvider(), List.of(new FakeLocalizer.Driver()));
        }

        @Override
        protected Map<String, String> parts() {
            return Map.of("localizer", "own-localizer");
        }
    }

    @Nested
    class OwnMap extends DeviceContract<Mapper> {
        OwnMap() {
            super(Mapper.class);
        }

        @Override
        protected RobotSystemProvider provider() {
            return new OverTheWire();
        }

        @Override
        protected Map<String, String> parts() {
            return Map.of("map", "own-map");
        }

        @Test
        void isTheWholeMapAsItIsSent() {
            advance(1);
            assertThat(device().latest().orElseThrow().value())
                    .usingRecursiveComparison()
                    .isEqualTo(WORLD.grid());
            assertThat(device().isComplete()).isTrue();
            assertThat(device().ends()).isEmpty();
        }
    }

    @Nested
    class OwnNavigator extends NavigatorContract {
        @Override
        protected RobotSystemProvider provider() {
            return new OverTheWire(new FakeProvider(), List.of(new FakeLocalizer.Driver(), new FakeNavigator.Driver()));
        }

        @Override
        protected Map<String, String> parts() {
            return Map.of("navigator", "own-navigator");
        }
    }
}
