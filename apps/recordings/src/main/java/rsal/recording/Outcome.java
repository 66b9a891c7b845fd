package rsal.recording;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Optional;
import rsal.recording.mcap.McapWriter;
import rsal.recording.mcap.Metadata;
import rsal.scenario.run.RunResult;

/// How a recorded run ended, as metadata of its file.
final class Outcome {
    static final String NAME = "rsal.result";

    private Outcome() {}

    /// @param result empty when the run broke, or its recording ended before it did
    static void write(McapWriter file, Optional<RunResult> result, long droppedStates) throws IOException {
        var entries = new LinkedHashMap<String, String>();
        result.ifPresent(ended -> {
            entries.put("outcome", ended.outcome());
            entries.put("simulatedSeconds", Double.toString(ended.simulatedSeconds()));
            entries.put("wallSeconds", Double.toString(ended.wallSeconds()));
            entries.put("eventHash", ended.eventHash());
            ended.measures()
                    .forEach((name, value) -> entries.put(
                            "measure." + name, value.isPresent() ? Double.toString(value.getAsDouble()) : ""));
        });
        entries.put("droppedStates", Long.toString(droppedStates));
        file.metadata(new Metadata(NAME, entries));
    }
}
