package rsal.sim;

import java.util.Set;
import org.junit.jupiter.api.Nested;
import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.Capability;
import rsal.testkit.contract.CarDriveContract;
import rsal.testkit.contract.DriveBaseContract;
import rsal.testkit.contract.LaserScannerContract;
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

        /// Its world has walls and robots only.
        @Override
        protected Set<Capability> cannot() {
            return Set.of(Capability.THINGS);
        }
    }
}
