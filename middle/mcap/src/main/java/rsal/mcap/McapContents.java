package rsal.mcap;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/// What is in a file, as far as it is known without its messages' data. Filled in by who reads it.
final class McapContents {
    String library = "";
    final Map<Integer, Schema> schemas = new TreeMap<>();
    final Map<Integer, Channel> channels = new TreeMap<>();
    final List<Metadata> metadata = new ArrayList<>();
    final List<AttachmentEntry> attachments = new ArrayList<>();
    final List<MessageBlock> blocks = new ArrayList<>();
    final Map<Integer, Long> counts = new TreeMap<>(); // messages by channel
    final List<String> damage = new ArrayList<>();

    void schema(RecordFields fields) throws Malformed {
        int id = fields.u16();
        var schema = new Schema(id, fields.string(), fields.string(), fields.bytes());
        if (id != 0) { // else it is to be ignored
            schemas.put(id, schema);
        }
    }

    void channel(RecordFields fields) throws Malformed {
        int id = fields.u16();
        channels.put(id, new Channel(id, fields.u16(), fields.string(), fields.string(), fields.map()));
    }

    void metadata(RecordFields fields) throws Malformed {
        metadata.add(new Metadata(fields.string(), fields.map()));
    }
}
