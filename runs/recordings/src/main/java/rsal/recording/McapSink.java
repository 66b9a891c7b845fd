package rsal.recording;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.Map;
import rsal.mcap.McapWriter;

/// Messages of a run go to a file. Each kind of them is described there once.
final class McapSink implements MessageSink {
    private static final String PROTOBUF = "protobuf";

    private final McapWriter file;
    private final Map<String, Integer> schemas = new HashMap<>(); // by name

    McapSink(McapWriter file) {
        this.file = file;
    }

    @Override
    public int open(String topic, String schema, byte[] descriptors, Map<String, String> about) throws IOException {
        Integer known = schemas.get(schema);
        if (known == null) {
            known = file.schema(schema, PROTOBUF, descriptors);
            schemas.put(schema, known);
        }
        return file.channel(known, topic, PROTOBUF, about);
    }

    @Override
    public void message(int channel, long time, long taken, ByteBuffer message) throws IOException {
        file.message(channel, time, taken, message);
    }
}
