package rsal.foxglove;

import rsal.testkit.architecture.ArchitectureRules;

class FoxgloveArchitectureTest extends ArchitectureRules {
    FoxgloveArchitectureTest() {
        super(FoxgloveServer.class);
    }
}
