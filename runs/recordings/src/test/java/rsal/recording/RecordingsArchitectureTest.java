package rsal.recording;

import rsal.mcap.McapFile;
import rsal.testkit.architecture.ArchitectureRules;

class RecordingsArchitectureTest extends ArchitectureRules {
    RecordingsArchitectureTest() {
        super(McapFile.class);
    }
}
