package rsal.ros2;

import rsal.ros2.link.RosLink;
import rsal.testkit.architecture.ArchitectureRules;

class Ros2ArchitectureTest extends ArchitectureRules {
    Ros2ArchitectureTest() {
        super(RosLink.class);
    }
}
