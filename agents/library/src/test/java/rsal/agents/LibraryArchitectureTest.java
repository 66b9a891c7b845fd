package rsal.agents;

import rsal.testkit.architecture.ArchitectureRules;

class LibraryArchitectureTest extends ArchitectureRules {
    LibraryArchitectureTest() {
        super(Follow.class);
    }
}
