package rsal.ros2.bag;

import rsal.testkit.architecture.ArchitectureRules;

class BagsArchitectureTest extends ArchitectureRules {
    BagsArchitectureTest() {
        super(BagFormat.class);
    }
}
