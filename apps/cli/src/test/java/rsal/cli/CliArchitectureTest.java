package rsal.cli;

import rsal.testkit.architecture.ArchitectureRules;

class CliArchitectureTest extends ArchitectureRules {
    CliArchitectureTest() {
        super(Main.class);
    }
}
