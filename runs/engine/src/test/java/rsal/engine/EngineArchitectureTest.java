package rsal.engine;

import rsal.testkit.architecture.ArchitectureRules;

class EngineArchitectureTest extends ArchitectureRules {
    EngineArchitectureTest() {
        super(LiveRun.class);
    }
}
