package rsal.testkit;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/// Reads bags of ROS 2 by rosbags and by MCAP's package, none of which is ours: all messages are deserialized by the
/// definitions in the bag, hashes of types, counts and times are compared with `metadata.yaml`, and checksums checked.
public final class OfficialBagReader {
    private static final String SCRIPT = """
            import sys, pathlib, collections
            from rosbags.highlevel import AnyReader
            from rosbags.rosbag2 import Reader
            from rosbags.typesys import Stores, get_typestore
            from mcap.reader import SeekingReader
            bag = pathlib.Path(sys.argv[1])
            store = get_typestore(Stores.ROS2_JAZZY)
            with Reader(bag) as reader:
                info = {c.topic: c for c in reader.connections}
                total, start, end = reader.message_count, reader.start_time, reader.end_time
                for c in reader.connections:
                    assert c.digest == store.hash_rihs01(c.msgtype), (c.topic, c.digest)
                    assert len(c.ext.offered_qos_profiles) == 1, c.ext
            counts, times, stamps = collections.Counter(), [], {}
            with AnyReader([bag]) as reader:
                for c, t, raw in reader.messages():
                    m = reader.deserialize(raw, c.msgtype)
                    counts[c.topic] += 1
                    times.append(t)
                    header = getattr(m, 'header', None) or (m.transforms[0].header if getattr(m, 'transforms', None) else None)
                    if header is not None:
                        s = header.stamp.sec * 10**9 + header.stamp.nanosec
                        stamps.setdefault(c.topic, []).append(s)
                    if len(sys.argv) > 2 and c.topic == sys.argv[2] and counts[c.topic] == 1: print('first', m)
            assert len(times) == total, (len(times), total)
            assert not times or (min(times) == start and max(times) + 1 == end), (min(times), start, max(times), end)
            for topic, s in stamps.items():
                assert s == sorted(s), topic
            for topic, c in info.items():
                assert c.msgcount == counts[topic], (topic, c.msgcount, counts[topic])
                print(topic, c.msgtype, counts[topic], c.ext.offered_qos_profiles[0].durability.name)
            files = list(bag.glob('*.mcap'))
            assert len(files) == 1, files
            with open(files[0], 'rb') as f:
                reader = SeekingReader(f, validate_crcs=True)
                assert reader.get_header().profile == 'ros2'
                assert sum(1 for _ in reader.iter_messages()) == total
                assert [m.name for m in reader.iter_metadata()] == ['rosbag2']
            """;

    private OfficialBagReader() {}

    /// Reads a bag.
    ///
    /// @param bag its folder
    /// @return a line for each topic: name, type, count, durability
    public static List<String> topics(Path bag) throws IOException, InterruptedException {
        return OfficialPython.run(SCRIPT, bag.toString()).lines().sorted().toList();
    }

    /// The first message of a topic, as Python prints it.
    public static String first(Path bag, String topic) throws IOException, InterruptedException {
        return OfficialPython.run(SCRIPT, bag.toString(), topic)
                .lines()
                .filter(line -> line.startsWith("first"))
                .findFirst()
                .orElseThrow();
    }
}
