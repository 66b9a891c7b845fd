package rsal.cli.show;

import java.io.IOException;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import rsal.cli.terminal.TextTable;
import rsal.mcap.Schema;
import rsal.recording.Recording;

/// What is in a recording.
///
/// @param bytes of the file
/// @param seconds from the first message to the last, by the clock of the run
/// @param run what it was made from, by name
/// @param result how it ended, by name; empty when that was not recorded
/// @param damage what is wrong with the file, a sentence each
record ShownRecording(
        String name,
        long bytes,
        double seconds,
        int chunks,
        Map<String, String> run,
        Map<String, String> result,
        List<Topic> topics,
        List<String> damage) {
    record Topic(String topic, String schema, long messages) {}

    static ShownRecording of(String name, Recording recording) throws IOException {
        var file = recording.file();
        return new ShownRecording(
                name,
                file.size(),
                recording.duration().toNanos() / 1e9,
                file.chunks(),
                recording.run(),
                recording.result(),
                file.channels().stream()
                        .map(channel -> new Topic(
                                channel.topic(),
                                file.schema(channel).map(Schema::name).orElse(""),
                                file.count(channel)))
                        .sorted(Comparator.comparing(Topic::topic))
                        .toList(),
                file.damage());
    }

    /// For people.
    String text() {
        var text = new StringBuilder("%s: a recording of %s:%s with seed %s%n"
                .formatted(name, run.get("scenario"), run.get("configuration"), run.get("seed")));
        text.append(String.format(
                Locale.ROOT, "%.1f s, %.1f MB in %d chunks; outcome %s%n", seconds, bytes / 1e6, chunks, outcome()));
        text.append("Begun %s by %s: %s%n%n".formatted(run.get("started"), run.get("program"), run.get("command")));
        var table = new TextTable("  ");
        topics.forEach(topic -> table.row(topic.topic(), Long.toString(topic.messages()), topic.schema()));
        text.append(table);
        if (!damage.isEmpty()) {
            text.append("\nDamaged:\n");
            damage.forEach(what -> text.append("  ").append(what).append('\n'));
        }
        return text.toString();
    }

    private String outcome() {
        return result.containsKey("outcome")
                ? "%s, event hash %s".formatted(result.get("outcome"), result.get("eventHash"))
                : "not recorded";
    }
}
