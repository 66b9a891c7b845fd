package rsal.navigation;

import rsal.navigation.grid.DistanceField;
import rsal.testkit.architecture.ArchitectureRules;

class NavigationArchitectureTest extends ArchitectureRules {
    NavigationArchitectureTest() {
        super(DistanceField.class);
    }
}
