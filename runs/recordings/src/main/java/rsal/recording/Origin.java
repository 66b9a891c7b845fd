package rsal.recording;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import rsal.mcap.Attachment;
import rsal.mcap.McapWriter;
import rsal.mcap.Metadata;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.text.Folders;

/// What a recorded run is made from: with that it can be run again.
///
/// @param program name and version of what ran it
/// @param command as it was typed, for people
/// @param started in real time
public record Origin(RunPlan plan, String program, String command, Instant started) {
    static final String NAME = "rsal.run";
    /// Version of what is recorded and how. A higher one can't be read. Older files have none.
    static final String FORMAT = "1";

    static final String FORMAT_KEY = "format";
    static final String FILES = "scenario/"; // names of attachments begin with it

    private static final long SECOND = 1_000_000_000;
    private static final String SET = "set.";

    /// When the run starts by its own clock, in ns: simulated time starts with the epoch.
    public long start() {
        return plan.clock() == RunPlan.Clock.SIMULATED ? 0 : started.getEpochSecond() * SECOND + started.getNano();
    }

    void write(McapWriter file) throws IOException {
        RunOptions options = plan.options();
        var entries = new LinkedHashMap<String, String>();
        entries.put(FORMAT_KEY, FORMAT);
        entries.put("scenario", plan.scenario().name());
        entries.put("file", Folders.without(plan.scenario().location().file()));
        entries.put("configuration", plan.configuration());
        entries.put("seed", Long.toString(plan.seed()));
        plan.arguments().forEach((name, value) -> entries.put("argument." + name, String.valueOf(value)));
        options.arguments().forEach((name, typed) -> entries.put(SET + name, typed));
        options.mas().ifPresent(key -> entries.put("option.mas", key));
        options.mrs().ifPresent(key -> entries.put("option.mrs", key));
        options.clock().ifPresent(key -> entries.put("option.clock", key));
        options.with().ifPresent(key -> entries.put("option.with", key));
        options.limit().ifPresent(time -> entries.put("option.for", time.toString()));
        entries.put("mas", plan.mas().provider().key());
        entries.put("mrs", plan.mrs().words());
        entries.put("clock", plan.clock().name());
        entries.put("step", plan.step().toString());
        entries.put("program", program);
        entries.put("java", System.getProperty("java.vm.version", ""));
        entries.put("machine", System.getProperty("os.name", "") + " " + System.getProperty("os.arch", ""));
        entries.put("command", Folders.without(command));
        entries.put("started", started.toString());
        file.metadata(new Metadata(NAME, entries));
        for (var read : plan.scenario().readFiles().entrySet()) {
            file.attachment(
                    new Attachment(start(), 0, FILES + read.getKey(), "application/octet-stream", read.getValue()));
        }
    }

    /// The options that a recorded run was planned with.
    ///
    /// @param entries as [#write] has them
    static RunOptions options(Map<String, String> entries) {
        var arguments = new LinkedHashMap<String, String>();
        entries.forEach((name, typed) -> {
            if (name.startsWith(SET)) {
                arguments.put(name.substring(SET.length()), typed);
            }
        });
        return new RunOptions(
                Optional.ofNullable(entries.get("configuration")),
                arguments,
                OptionalLong.of(Long.parseLong(entries.getOrDefault("seed", "0"))),
                Optional.ofNullable(entries.get("option.mas")),
                Optional.ofNullable(entries.get("option.mrs")),
                Optional.ofNullable(entries.get("option.clock")),
                Optional.ofNullable(entries.get("option.with")),
                Optional.ofNullable(entries.get("option.for")).map(Duration::parse),
                OptionalDouble.of(Double.POSITIVE_INFINITY));
    }
}
