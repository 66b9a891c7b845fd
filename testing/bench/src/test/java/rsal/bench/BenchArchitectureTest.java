package rsal.bench;

import rsal.testkit.architecture.ArchitectureRules;

class BenchArchitectureTest extends ArchitectureRules {
    BenchArchitectureTest() {
        super(Area.class);
    }
}
