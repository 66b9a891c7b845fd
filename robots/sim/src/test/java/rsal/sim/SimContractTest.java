package rsal.sim;

import org.junit.jupiter.api.Nested;
import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.ActuatorContract;
import rsal.testkit.contract.BatteryContract;
import rsal.testkit.contract.BlobFinderContract;
import rsal.testkit.contract.BumperContract;
import rsal.testkit.contract.CameraContract;
import rsal.testkit.contract.CarDriveContract;
import rsal.testkit.contract.DriveBaseContract;
import rsal.testkit.contract.FiducialFinderContract;
import rsal.testkit.contract.GripperContract;
import rsal.testkit.contract.ImuContract;
import rsal.testkit.contract.LaserScannerContract;
import rsal.testkit.contract.LightContract;
import rsal.testkit.contract.OmnidirectionalDriveContract;
import rsal.testkit.contract.RobotSystemContract;
import rsal.testkit.contract.SimulationControlContract;
import rsal.testkit.contract.SonarArrayContract;

/// The simulation is a robot system like any other.
class SimContractTest {
    @Nested
    class Whole extends RobotSystemContract {
        @Override
        protected RobotSystemProvider provider() {
            return new SimProvider();
        }
    }

    @Nested
    class Drive extends DriveBaseContract {
        @Override
        protected RobotSystemProvider provider() {
            return new SimProvider();
        }
    }

    @Nested
    class Omnidirectional extends OmnidirectionalDriveContract {
        @Override
        protected RobotSystemProvider provider() {
            return new SimProvider();
        }
    }

    @Nested
    class Car extends CarDriveContract {
        @Override
        protected RobotSystemProvider provider() {
            return new SimProvider();
        }
    }

    @Nested
    class Laser extends LaserScannerContract {
        @Override
        protected RobotSystemProvider provider() {
            return new SimProvider();
        }
    }

    @Nested
    class Sonar extends SonarArrayContract {
        @Override
        protected RobotSystemProvider provider() {
            return new SimProvider();
        }
    }

    @Nested
    class Control extends SimulationControlContract {
        @Override
        protected RobotSystemProvider provider() {
            return new SimProvider();
        }
    }

    @Nested
    class BlobFinder extends BlobFinderContract {
        @Override
        protected RobotSystemProvider provider() {
            return new SimProvider();
        }
    }

    @Nested
    class FiducialFinder extends FiducialFinderContract {
        @Override
        protected RobotSystemProvider provider() {
            return new SimProvider();
        }
    }

    @Nested
    class Bumper extends BumperContract {
        @Override
        protected RobotSystemProvider provider() {
            return new SimProvider();
        }
    }

    @Nested
    class Battery extends BatteryContract {
        @Override
        protected RobotSystemProvider provider() {
            return new SimProvider();
        }
    }

    @Nested
    class Light extends LightContract {
        @Override
        protected RobotSystemProvider provider() {
            return new SimProvider();
        }
    }

    @Nested
    class Gripper extends GripperContract {
        @Override
        protected RobotSystemProvider provider() {
            return new SimProvider();
        }
    }

    @Nested
    class Actuator extends ActuatorContract {
        @Override
        protected RobotSystemProvider provider() {
            return new SimProvider();
        }
    }

    @Nested
    class Inertial extends ImuContract {
        @Override
        protected RobotSystemProvider provider() {
            return new SimProvider();
        }
    }

    @Nested
    class ImageCamera extends CameraContract {
        @Override
        protected RobotSystemProvider provider() {
            return new SimProvider();
        }
    }
}
