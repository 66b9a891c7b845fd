package rsal.player;

import rsal.player.message.Protocol;
import rsal.testkit.architecture.ArchitectureRules;

class PlayerArchitectureTest extends ArchitectureRules {
    PlayerArchitectureTest() {
        super(Protocol.class);
    }
}
