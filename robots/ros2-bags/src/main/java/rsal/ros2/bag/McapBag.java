package rsal.ros2.bag;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Predicate;
import rsal.mcap.Channel;
import rsal.mcap.McapFile;
import rsal.mcap.Schema;

/// A file in MCAP, the default since Iron.
final class McapBag implements BagFile {
    private final McapFile file;
    private final BagTopics<Channel> topics = new BagTopics<>();

    /// @throws rsal.mcap.InvalidMcap when it is not an MCAP file
    McapBag(Path path) throws IOException {
        file = McapFile.open(path);
        file.channels().forEach(channel -> topics.put(channel, topic(channel)));
    }

    private Topic topic(Channel channel) {
        Schema schema = file.schema(channel).orElse(new Schema(0, "", "", new byte[0]));
        String definition =
                schema.encoding().equals("ros2msg") ? new String(schema.data(), StandardCharsets.UTF_8) : "";
        return new Topic(channel.topic(), schema.name(), definition);
    }

    @Override
    public List<Topic> topics() {
        return topics.distinct();
    }

    @Override
    public long count(Topic topic) {
        return topics.count(topic, file::count);
    }

    @Override
    public void read(Predicate<Topic> wanted, Visitor visitor) throws IOException {
        file.read(
                channel -> wanted.test(known(channel)),
                (channel, _, _, _, data) -> visitor.message(known(channel), data));
    }

    private Topic known(Channel channel) {
        return topics.get(channel).orElseThrow(); // of this file
    }

    @Override
    public List<String> damage() {
        return file.damage();
    }

    @Override
    public void close() throws IOException {
        file.close();
    }
}
