package rsal.gazebo;

import rsal.testkit.architecture.ArchitectureRules;

class GazeboArchitectureTest extends ArchitectureRules {
    GazeboArchitectureTest() {
        super(SdfFormat.class);
    }
}
