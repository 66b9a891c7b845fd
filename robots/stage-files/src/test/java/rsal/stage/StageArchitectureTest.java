package rsal.stage;

import rsal.testkit.architecture.ArchitectureRules;

class StageArchitectureTest extends ArchitectureRules {
    StageArchitectureTest() {
        super(StageFormat.class);
    }
}
