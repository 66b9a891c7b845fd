package rsal.recording;

import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import rsal.engine.report.RunEvent;
import rsal.mcap.AttachmentEntry;
import rsal.mcap.McapFile;
import rsal.recording.proto.ProtoReader;
import rsal.scenario.RunPlan;
import rsal.scenario.Scenario;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// A recorded run, to be looked at and run again. For one thread.
public final class Recording implements Closeable {
    private final String name;
    private final McapFile file;
    private final Map<String, String> run;

    /// An event, with the hash over all that had happened up to it.
    public record Hashed(RunEvent event, String hash) {}

    private Recording(String name, McapFile file) {
        this.name = name;
        this.file = file;
        this.run = file.metadata(Origin.NAME);
    }

    /// @param name of the file
    /// @param checked whether all of it is read, so that all damage is known
    /// @throws InvalidSettings when it is no recording of a run
    /// @throws IOException when it can't be read
    public static Recording open(String name, boolean checked) throws IOException {
        McapFile file = checked ? McapFile.check(Path.of(name)) : McapFile.open(Path.of(name));
        var recording = new Recording(name, file);
        if (recording.run.isEmpty()) {
            file.close();
            throw new InvalidSettings(
                    Location.of(name),
                    "This is an MCAP, but no recording of a run.",
                    "Maybe it is a bag of ROS 2, for 'rsal map' and 'rsal localize', or was cut off at its very beginning.");
        }
        String format = recording.run.getOrDefault(Origin.FORMAT_KEY, Origin.FORMAT);
        if (!format.equals(Origin.FORMAT)) {
            file.close();
            throw new InvalidSettings(
                    Location.of(name),
                    "This recording has format '%s'; this RSAL reads format %s.".formatted(format, Origin.FORMAT),
                    "It was made by '%s': use that, or a newer one."
                            .formatted(recording.run.getOrDefault("program", "another RSAL")));
        }
        return recording;
    }

    /// The file itself.
    public McapFile file() {
        return file;
    }

    /// What the run was made from, by name: `scenario`, `configuration`, `seed`, `argument.<name>`, `program`,
    /// `command`.
    public Map<String, String> run() {
        return run;
    }

    /// How the run ended, by name: `outcome`, `simulatedSeconds`, `eventHash`, `metric.<name>`; empty when that
    /// was not recorded.
    public Map<String, String> result() {
        return file.metadata(RecordedOutcome.NAME);
    }

    /// Whether the run was in simulated time, and so can be run again.
    public boolean isRepeatable() {
        return RunPlan.Clock.SIMULATED.name().equals(run.get("clock"));
    }

    /// From the first message to the last, by the clock of the run.
    public Duration duration() {
        return Duration.ofNanos(file.end().orElse(0) - file.start().orElse(0));
    }

    /// The run, to be run again, from what was recorded of its scenario's files.
    ///
    /// @param trusted whether agents' programs that were recorded with it may be run; those that made the
    ///         recording may have written anything into them
    /// @throws InvalidSettings with every error, as of an argument that a later version has no more
    public RunPlan plan(boolean trusted) throws IOException {
        var files = new LinkedHashMap<String, byte[]>();
        for (AttachmentEntry entry : file.attachments()) {
            if (entry.name().startsWith(Origin.FILES)) {
                files.put(
                        entry.name().substring(Origin.FILES.length()),
                        file.attachment(entry).data());
            }
        }
        return Scenario.again(run.getOrDefault("file", name), files, trusted).plan(Origin.options(run));
    }

    /// All events, oldest first.
    public List<Hashed> events() throws IOException {
        var events = new ArrayList<Hashed>();
        file.read(channel -> channel.topic().equals(ChannelNames.EVENTS), (_, _, time, _, data) -> {
            Map<String, Object> fields = ProtoReader.read(Own.EVENT, data);
            events.add(new Hashed(
                    new RunEvent(
                            number(fields, "sequence"),
                            Duration.ofNanos(time),
                            text(fields, "kind"),
                            text(fields, "subject"),
                            text(fields, "text")),
                    text(fields, "hash")));
        });
        return events;
    }

    /// Hashes over all that had happened, by when the state was recorded.
    public Map<Duration, String> hashes() throws IOException {
        var hashes = new TreeMap<Duration, String>();
        file.read(
                channel -> channel.topic().equals(ChannelNames.STATE),
                (_, _, time, _, data) ->
                        hashes.put(Duration.ofNanos(time), text(ProtoReader.read(Own.STATE, data), "hash")));
        return hashes;
    }

    private static String text(Map<String, Object> fields, String name) {
        return String.valueOf(fields.get(name));
    }

    private static long number(Map<String, Object> fields, String name) {
        return fields.get(name) instanceof Long number ? number : 0;
    }

    @Override
    public void close() throws IOException {
        file.close();
    }
}
