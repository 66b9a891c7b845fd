package rsal.python;

import rsal.testkit.architecture.ArchitectureRules;

class PythonArchitectureTest extends ArchitectureRules {
    PythonArchitectureTest() {
        super(PythonLanguage.class);
    }
}
