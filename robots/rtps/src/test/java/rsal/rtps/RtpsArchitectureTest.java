package rsal.rtps;

import rsal.testkit.architecture.ArchitectureRules;

class RtpsArchitectureTest extends ArchitectureRules {
    RtpsArchitectureTest() {
        super(Participant.class);
    }
}
