package rsal.server;

import rsal.testkit.architecture.ArchitectureRules;

class ServerArchitectureTest extends ArchitectureRules {
    ServerArchitectureTest() {
        super(RunServer.class);
    }
}
