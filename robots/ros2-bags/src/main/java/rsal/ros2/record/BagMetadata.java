package rsal.ros2.record;

import java.util.List;

/// What `metadata.yaml` says of a bag, in version 9, that of Jazzy and later.
///
/// @param file the only one of the bag
/// @param start time of the first message [ns]
/// @param duration from the first to the last [ns]
record BagMetadata(String file, long start, long duration, long messages, List<Topic> topics) {
    static final String NAME = "metadata.yaml";

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

    /// Names of files may have any characters.
    private static String quoted(String text) {
        return '"' + text.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
    }
}
