package rsal.java;

import rsal.testkit.architecture.ArchitectureRules;

class JavaArchitectureTest extends ArchitectureRules {
    JavaArchitectureTest() {
        super(JavaLanguage.class);
    }
}
