package rsal.ros2.type;

import rsal.testkit.architecture.ArchitectureRules;

class Ros2TypesArchitectureTest extends ArchitectureRules {
    Ros2TypesArchitectureTest() {
        super(RosType.class);
    }
}
