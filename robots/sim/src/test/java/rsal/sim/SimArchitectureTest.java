package rsal.sim;

import rsal.testkit.architecture.ArchitectureRules;

class SimArchitectureTest extends ArchitectureRules {
    SimArchitectureTest() {
        super(SimProvider.class);
    }
}
