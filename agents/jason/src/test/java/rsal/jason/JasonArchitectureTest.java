package rsal.jason;

import rsal.testkit.architecture.ArchitectureRules;

class JasonArchitectureTest extends ArchitectureRules {
    JasonArchitectureTest() {
        super(JasonHostProvider.class);
    }
}
