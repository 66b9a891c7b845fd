package rsal.agents;

import rsal.agents.pursuit.Follow;
import rsal.testkit.architecture.ArchitectureRules;

class LibraryArchitectureTest extends ArchitectureRules {
    LibraryArchitectureTest() {
        super(Follow.class);
    }
}
