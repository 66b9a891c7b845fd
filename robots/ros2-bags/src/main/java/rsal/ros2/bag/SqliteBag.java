package rsal.ros2.bag;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import java.util.stream.Stream;
import rsal.ros2.sqlite.InvalidSqlite;
import rsal.ros2.sqlite.SqliteFile;
import rsal.ros2.sqlite.SqliteRow;
import rsal.ros2.sqlite.SqliteTable;

/// A file in SQLite, the default up to Humble. Distributions have added columns and tables; what is missing is empty.
final class SqliteBag implements BagFile {
    private static final int MOST_TOPICS = 0xffff; // as MCAP has at most
    private static final String ID = "id";

    private final SqliteFile file;
    private final SqliteTable messages;
    private final BagTopics<Long> topics = new BagTopics<>(); // by id
    private final Map<Long, Long> counts = new HashMap<>(); // the same
    private long strays; // messages of no topic

    /// Reads all ids of messages once, to count them.
    ///
    /// @throws InvalidSqlite when it is not a database of SQLite, or no bag
    SqliteBag(Path path) throws IOException {
        file = SqliteFile.open(path);
        try {
            messages = table(path, "messages");
            readTopics(table(path, "topics"));
            int topic = messages.column("topic_id");
            file.read(messages, row -> {
                long id = row.integer(topic).orElse(-1);
                if (topics.get(id).isPresent()) {
                    counts.merge(id, 1L, Long::sum);
                } else {
                    strays++;
                }
            });
        } catch (IOException | RuntimeException e) {
            file.close();
            throw e;
        }
    }

    private SqliteTable table(Path path, String name) throws IOException {
        return file.table(name)
                .orElseThrow(
                        () -> new NoBag("File '%s' is a database of SQLite, but no bag of ROS 2: it has no table '%s'."
                                .formatted(path, name)));
    }

    /// A database of something else.
    static final class NoBag extends IOException {
        private static final long serialVersionUID = 1;

        NoBag(String message) {
            super(message);
        }
    }

    private void readTopics(SqliteTable table) throws IOException {
        Map<String, String> definitions = definitions();
        int id = table.column(ID);
        int name = table.column("name");
        int type = table.column("type");
        file.read(table, row -> {
            if (topics.size() < MOST_TOPICS) {
                String typeName = row.text(type);
                topics.put(id(row, id), new Topic(row.text(name), typeName, definitions.getOrDefault(typeName, "")));
            }
        });
    }

    private static long id(SqliteRow row, int column) throws IOException {
        return row.integer(column).orElse(row.id());
    }

    /// By type; since Iron.
    private Map<String, String> definitions() throws IOException {
        var definitions = new HashMap<String, String>();
        SqliteTable table = file.table("message_definitions").orElse(null);
        if (table != null) {
            int type = table.column("topic_type");
            int encoding = table.column("encoding");
            int text = table.column("encoded_message_definition");
            file.read(table, row -> {
                if (row.text(encoding).equals("ros2msg") && definitions.size() < MOST_TOPICS) {
                    definitions.put(row.text(type), row.text(text));
                }
            });
        }
        return definitions;
    }

    @Override
    public List<Topic> topics() {
        return topics.distinct();
    }

    @Override
    public long count(Topic topic) {
        return topics.count(topic, id -> counts.getOrDefault(id, 0L));
    }

    @Override
    public void read(Predicate<Topic> wanted, Visitor visitor) throws IOException {
        int topicId = messages.column("topic_id");
        int data = messages.column("data");
        Map<Long, Topic> chosen = topics.chosen(wanted); // once, as there are many rows
        file.read(messages, row -> {
            Topic topic = chosen.get(row.integer(topicId).orElse(-1));
            if (topic != null) {
                visitor.message(topic, ByteBuffer.wrap(row.data(data)));
            }
        });
    }

    @Override
    public List<String> damage() {
        return Stream.concat(
                        file.damage().stream(),
                        Stream.of("%d messages are of topics that are not described; they are lost.".formatted(strays))
                                .filter(_ -> strays > 0))
                .toList();
    }

    @Override
    public void close() throws IOException {
        file.close();
    }
}
