package rsal.testkit.architecture;

import org.junit.jupiter.api.Nested;
import rsal.agent.Agent;
import rsal.data.Pose2d;
import rsal.device.Device;
import rsal.testkit.DrawnMap;

/// The rules for the modules that can't depend on the testkit, and for itself.
class ModulesTest {
    @Nested
    class Data extends ArchitectureRules {
        Data() {
            super(Pose2d.class);
        }
    }

    @Nested
    class Devices extends ArchitectureRules {
        Devices() {
            super(Device.class);
        }
    }

    @Nested
    class Agents extends ArchitectureRules {
        Agents() {
            super(Agent.class);
        }
    }

    @Nested
    class Testkit extends ArchitectureRules {
        Testkit() {
            super(DrawnMap.class);
        }
    }
}
