package rsal.experiment;

import rsal.testkit.architecture.ArchitectureRules;

class ExperimentsArchitectureTest extends ArchitectureRules {
    ExperimentsArchitectureTest() {
        super(Sweep.class);
    }
}
