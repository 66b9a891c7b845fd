package rsal.jade;

import rsal.testkit.architecture.ArchitectureRules;

class JadeArchitectureTest extends ArchitectureRules {
    JadeArchitectureTest() {
        super(JadeHostProvider.class);
    }
}
