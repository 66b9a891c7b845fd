package rsal.jadex;

import java.util.List;
import rsal.testkit.architecture.ClassRules;

/// Not among those that the command line's tests try at once: it comes only when it is asked for.
class JadexArchitectureTest extends ClassRules {
    JadexArchitectureTest() {
        super(List.of(home(JadexHostProvider.class)));
    }
}
