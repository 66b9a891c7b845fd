package rsal.recording;

import rsal.recording.mcap.McapFile;
import rsal.testkit.architecture.ArchitectureRules;

class RecordingsArchitectureTest extends ArchitectureRules {
    RecordingsArchitectureTest() {
        super(McapFile.class);
    }
}
