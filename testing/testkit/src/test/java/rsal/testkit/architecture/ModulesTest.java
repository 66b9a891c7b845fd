package rsal.testkit.architecture;

import org.junit.jupiter.api.Nested;
import rsal.agent.Agent;
import rsal.agent.platform.AgentPlatform;
import rsal.behavior.Subsumption;
import rsal.data.Pose2d;
import rsal.device.Device;
import rsal.model.RobotModels;
import rsal.settings.Parameter;
import rsal.testkit.DrawnMap;
import rsal.yaml.Yaml;

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
    class Settings extends ArchitectureRules {
        Settings() {
            super(Parameter.class);
        }
    }

    @Nested
    class Yamls extends ArchitectureRules {
        Yamls() {
            super(Yaml.class);
        }
    }

    @Nested
    class Models extends ArchitectureRules {
        Models() {
            super(RobotModels.class);
        }
    }

    @Nested
    class Behaviors extends ArchitectureRules {
        Behaviors() {
            super(Subsumption.class);
        }
    }

    @Nested
    class Agents extends ArchitectureRules {
        Agents() {
            super(Agent.class);
        }
    }

    @Nested
    class Platform extends ArchitectureRules {
        Platform() {
            super(AgentPlatform.class);
        }
    }

    @Nested
    class Testkit extends ArchitectureRules {
        Testkit() {
            super(DrawnMap.class);
        }
    }
}
