package rsal.ros2.record;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/// What `metadata.yaml` says of a bag, in version 9, that of Jazzy and later.
///
/// @param file the only one of the bag
/// @param start time of the first message [ns]
/// @param duration from the first to the last [ns]
record BagMetadata(String file, long start, long duration, long messages, List<Topic> topics) {
    static final String NAME = "metadata.yaml";
    private static final long MOST_BYTES = 64 << 20;
    private static final Pattern FILE = Pattern.compile("\\s*- \"?(.+?)\"?\\s*");

    /// @param hash of its type, `RIHS01_…`
    record Topic(String name, String type, String hash, OfferedQuality quality, long messages) {}

    String yaml() {
        var text = new StringBuilder(
                """
                rosbag2_bagfile_information:
                  version: 9
                  storage_identifier: mcap
                  duration:
                    nanoseconds: %1$d
                  starting_time:
                    nanoseconds_since_epoch: %2$d
                  message_count: %3$d
                  compression_format: ""
                  compression_mode: ""
                  relative_file_paths:
                    - %4$s
                  files:
                    - path: %4$s
                      starting_time:
                        nanoseconds_since_epoch: %2$d
                      duration:
                        nanoseconds: %1$d
                      message_count: %3$d
                  custom_data: ~
                  ros_distro: jazzy
                  topics_with_message_count:%5$s
                """.formatted(duration, start, messages, quoted(file), topics.isEmpty() ? " []" : ""));
        for (Topic topic : topics) {
            text.append("""
                        - topic_metadata:
                            name: %s
                            type: %s
                            serialization_format: cdr
                            type_description_hash: %s
                            offered_qos_profiles:
                    %s      message_count: %d
                    """.formatted(
                    topic.name(), topic.type(), topic.hash(), topic.quality().yaml(10), topic.messages()));
        }
        return text.toString();
    }

    /// The files that a `metadata.yaml` names, of any version; empty where there is none, or it is of something else.
    static Optional<List<String>> files(Path metadata) throws IOException {
        if (!Files.isRegularFile(metadata) || Files.size(metadata) > MOST_BYTES) {
            return Optional.empty();
        }
        List<String> lines = Files.readAllLines(metadata);
        if (lines.isEmpty() || !lines.getFirst().startsWith("rosbag2_bagfile_information:")) {
            return Optional.empty();
        }
        return Optional.of(lines.stream()
                .dropWhile(line -> !line.strip().equals("relative_file_paths:"))
                .skip(1)
                .map(FILE::matcher)
                .takeWhile(Matcher::matches)
                .map(line -> line.group(1).replace("\\\"", "\"").replace("\\\\", "\\"))
                .filter(file -> !file.contains("/")) // none outside of the folder
                .toList());
    }

    /// Names of files may have any characters.
    private static String quoted(String text) {
        return '"' + text.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
    }
}
