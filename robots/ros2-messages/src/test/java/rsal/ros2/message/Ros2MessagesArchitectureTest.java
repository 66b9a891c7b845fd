package rsal.ros2.message;

import rsal.testkit.architecture.ArchitectureRules;

class Ros2MessagesArchitectureTest extends ArchitectureRules {
    Ros2MessagesArchitectureTest() {
        super(ScanMessage.class);
    }
}
