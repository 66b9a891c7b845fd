package rsal.mcap;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Predicate;

/// A file to be read, by its index if that is whole, else as far as it goes. What is damaged is left out and told
/// ([#damage]); every length is checked before it is believed, and at most a few chunks are in memory at once.
///
/// For one thread.
public final class McapFile implements Closeable {
    private static final long MOST_AT_ONCE = 2L * Chunks.MOST; // [B] of chunks whose times overlap

    private final FileChannel file;
    private final Chunks chunks;
    private final McapContents contents;

    private McapFile(FileChannel file, Chunks chunks, McapContents contents) {
        this.file = file;
        this.chunks = chunks;
        this.contents = contents;
        contents.blocks.sort(Comparator.comparingLong(MessageBlock::start).thenComparingLong(MessageBlock::offset));
    }

    /// Opens a file. Damage of chunks is found when they are read, unless there is no index to go by.
    ///
    /// @throws InvalidMcap when it is not an MCAP file
    public static McapFile open(Path path) throws IOException {
        return open(path, false);
    }

    /// Opens a file and reads all of it, so that all damage is known.
    ///
    /// @throws InvalidMcap when it is not an MCAP file
    public static McapFile check(Path path) throws IOException {
        return open(path, true);
    }

    private static McapFile open(Path path, boolean checked) throws IOException {
        FileChannel file = FileChannel.open(path, StandardOpenOption.READ);
        var window = new FileWindow(file);
        var chunks = new Chunks(window);
        try {
            return new McapFile(file, chunks, contents(path, file.size(), window, chunks, checked));
        } catch (IOException | RuntimeException e) {
            file.close();
            chunks.close();
            throw e;
        }
    }

    private static McapContents contents(Path path, long size, FileWindow window, Chunks chunks, boolean checked)
            throws IOException {
        byte[] magic = Opcode.magic();
        byte[] first = new byte[magic.length];
        if (size >= magic.length) {
            window.at(0, magic.length).get(first);
        }
        if (!Arrays.equals(magic, first)) {
            throw new InvalidMcap("File '%s' is not an MCAP file: it does not begin like one.".formatted(path));
        }
        String broken = "";
        Optional<McapContents> indexed = Optional.empty();
        try {
            indexed = new Summary(window, size).read();
        } catch (Malformed e) {
            broken = String.valueOf(e.getMessage());
        }
        if (indexed.isPresent() && !checked) {
            return indexed.get();
        }
        McapContents scanned = new Scan(window, chunks, size).read(checked);
        if (!broken.isEmpty() && scanned.damage.isEmpty()) {
            scanned.damage.add("The index can't be used: %s. The messages are whole.".formatted(broken));
        }
        return scanned;
    }

    /// What wrote it.
    public String library() {
        return contents.library;
    }

    public Collection<Channel> channels() {
        return List.copyOf(contents.channels.values());
    }

    public Optional<Schema> schema(Channel channel) {
        return Optional.ofNullable(contents.schemas.get(channel.schema()));
    }

    /// How many messages a channel has, as far as is known.
    public long count(Channel channel) {
        return contents.counts.getOrDefault(channel.id(), 0L);
    }

    public List<Metadata> metadata() {
        return List.copyOf(contents.metadata);
    }

    /// The last of that name: what is written later replaces what was written before.
    public Map<String, String> metadata(String name) {
        return contents.metadata.reversed().stream()
                .filter(about -> about.name().equals(name))
                .findFirst()
                .map(Metadata::entries)
                .orElse(Map.of());
    }

    public List<AttachmentEntry> attachments() {
        return List.copyOf(contents.attachments);
    }

    /// @throws InvalidMcap when it is damaged
    public Attachment attachment(AttachmentEntry entry) throws IOException {
        return Attachments.read(new FileWindow(file), entry);
    }

    /// Earliest log time of a message, in ns; empty when there is none.
    public OptionalLong start() {
        return contents.blocks.stream().mapToLong(MessageBlock::start).min();
    }

    /// Latest log time of a message, in ns; empty when there is none.
    public OptionalLong end() {
        return contents.blocks.stream().mapToLong(MessageBlock::end).max();
    }

    public int chunks() {
        return (int) contents.blocks.stream().filter(MessageBlock::isChunk).count();
    }

    /// How long the file is [B].
    public long size() throws IOException {
        return file.size();
    }

    /// What is wrong with it and lost, a sentence each, as far as it was found yet.
    public List<String> damage() {
        return List.copyOf(contents.damage);
    }

    /// Reads all messages, by log time; those of the same time as they come in the file.
    public void read(Predicate<Channel> wanted, MessageVisitor visitor) throws IOException {
        read(Long.MIN_VALUE, Long.MAX_VALUE, wanted, visitor);
    }

    /// Reads messages, by log time; those of the same time as they come in the file. Chunks that have none of them are
    /// not read.
    ///
    /// @param from earliest log time, in ns
    /// @param to latest log time, in ns
    public void read(long from, long to, Predicate<Channel> wanted, MessageVisitor visitor) throws IOException {
        var ids = new BitSet();
        contents.channels.values().stream().filter(wanted).map(Channel::id).forEach(ids::set);
        List<MessageBlock> blocks = contents.blocks.stream()
                .filter(block -> block.end() >= from
                        && block.start() <= to
                        && block.channels().intersects(ids))
                .toList();
        for (int first = 0; first < blocks.size(); ) {
            int next = first + 1;
            long end = blocks.get(first).end();
            while (next < blocks.size() && blocks.get(next).start() < end) { // their messages mix
                end = Math.max(end, blocks.get(next).end());
                next++;
            }
            read(blocks.subList(first, next), new Wanted(from, to, ids), visitor);
            first = next;
        }
    }

    private record Wanted(long from, long to, BitSet channels) {
        boolean has(ByteBuffer records, int at) {
            long time = records.getLong(at + Opcode.PREFIX + 6);
            return records.get(at) == Opcode.MESSAGE
                    && time >= from
                    && time <= to
                    && channels.get(Short.toUnsignedInt(records.getShort(at + Opcode.PREFIX)));
        }
    }

    private void read(List<MessageBlock> blocks, Wanted wanted, MessageVisitor visitor) throws IOException {
        if (blocks.size() == 1) {
            read(blocks.getFirst(), wanted, visitor);
            return;
        }
        var all = new ArrayList<Place>();
        long bytes = 0;
        for (MessageBlock block : blocks) {
            Optional<ByteBuffer> records = records(block, true);
            bytes += records.map(ByteBuffer::limit).orElse(0);
            if (bytes > MOST_AT_ONCE) {
                throw new InvalidMcap("Too many chunks are about the same time, from %d ns on: more than %d bytes."
                        .formatted(blocks.getFirst().start(), MOST_AT_ONCE));
            }
            if (records.isPresent()) {
                each(records.get(), (at, next) -> {
                    if (wanted.has(records.get(), at)) {
                        all.add(new Place(records.get(), at, next));
                    }
                });
            }
        }
        all.sort(Comparator.comparingLong(Place::time)); // stable
        for (Place place : all) {
            visit(place.records(), place.at(), place.next(), visitor);
        }
    }

    private void read(MessageBlock block, Wanted wanted, MessageVisitor visitor) throws IOException {
        Optional<ByteBuffer> found = records(block, false);
        if (found.isEmpty()) {
            return;
        }
        ByteBuffer records = found.get();
        if (isInOrder(records)) {
            each(records, (at, next) -> {
                if (wanted.has(records, at)) {
                    visit(records, at, next, visitor);
                }
            });
            return;
        }
        var all = new ArrayList<Place>();
        each(records, (at, next) -> {
            if (wanted.has(records, at)) {
                all.add(new Place(records, at, next));
            }
        });
        all.sort(Comparator.comparingLong(Place::time)); // stable
        for (Place place : all) {
            visit(records, place.at(), place.next(), visitor);
        }
    }

    private record Place(ByteBuffer records, int at, int next) {
        long time() {
            return records.getLong(at + Opcode.PREFIX + 6);
        }
    }

    private interface RecordVisitor {
        void record(int at, int next) throws IOException;
    }

    private static void each(ByteBuffer records, RecordVisitor visitor) throws IOException {
        try {
            for (int at = 0; at < records.limit(); ) {
                int next = Chunks.after(records, at);
                if (records.get(at) == Opcode.MESSAGE) {
                    visitor.record(at, next);
                }
                at = next;
            }
        } catch (Malformed e) {
            throw new AssertionError("They were checked.", e);
        }
    }

    private static boolean isInOrder(ByteBuffer records) throws IOException {
        long[] last = {Long.MIN_VALUE};
        boolean[] inOrder = {true};
        each(records, (at, _) -> {
            long time = records.getLong(at + Opcode.PREFIX + 6);
            inOrder[0] &= time >= last[0];
            last[0] = time;
        });
        return inOrder[0];
    }

    /// Checked; empty when it is damaged, which is told.
    private Optional<ByteBuffer> records(MessageBlock block, boolean own) throws IOException {
        try {
            ByteBuffer records = chunks.records(block, own);
            for (int at = 0; at < records.limit(); ) {
                at = Chunks.after(records, at);
            }
            return Optional.of(records);
        } catch (Malformed e) {
            String note = "The chunk at byte %d, of %d bytes, is lost: %s."
                    .formatted(block.offset(), block.length() - Opcode.PREFIX, e.getMessage());
            if (!contents.damage.contains(note)) {
                contents.damage.add(note);
            }
            return Optional.empty();
        }
    }

    private void visit(ByteBuffer records, int at, int next, MessageVisitor visitor) throws IOException {
        int content = at + Opcode.PREFIX;
        Channel channel = contents.channels.get(Short.toUnsignedInt(records.getShort(content)));
        if (channel != null) {
            visitor.message(
                    channel,
                    Integer.toUnsignedLong(records.getInt(content + 2)),
                    records.getLong(content + 6),
                    records.getLong(content + 14),
                    records.slice(content + Opcode.MESSAGE_HEAD, next - content - Opcode.MESSAGE_HEAD)
                            .order(ByteOrder.LITTLE_ENDIAN));
        }
    }

    @Override
    public void close() throws IOException {
        try (file) {
            chunks.close();
        }
    }
}
