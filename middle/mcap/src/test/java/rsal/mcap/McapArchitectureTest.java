package rsal.mcap;

import rsal.testkit.architecture.ArchitectureRules;

class McapArchitectureTest extends ArchitectureRules {
    McapArchitectureTest() {
        super(McapFile.class);
    }
}
