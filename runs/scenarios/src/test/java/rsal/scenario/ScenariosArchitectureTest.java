package rsal.scenario;

import rsal.testkit.architecture.ArchitectureRules;

class ScenariosArchitectureTest extends ArchitectureRules {
    ScenariosArchitectureTest() {
        super(Scenario.class);
    }
}
