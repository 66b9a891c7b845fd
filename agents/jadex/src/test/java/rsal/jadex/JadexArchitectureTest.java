package rsal.jadex;

import rsal.testkit.architecture.ArchitectureRules;

class JadexArchitectureTest extends ArchitectureRules {
    JadexArchitectureTest() {
        super(JadexHostProvider.class);
    }
}
