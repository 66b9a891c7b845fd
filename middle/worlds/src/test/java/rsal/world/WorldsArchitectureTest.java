package rsal.world;

import rsal.testkit.architecture.ArchitectureRules;

class WorldsArchitectureTest extends ArchitectureRules {
    WorldsArchitectureTest() {
        super(SceneFormat.class);
    }
}
