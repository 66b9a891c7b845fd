package rsal.recording;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/// The newest of everything that was recorded up to some time: messages as they are in the file, and what agents said
/// last. For one thread.
final class NewestRecords {
    static final int LAST_WORDS = 5; // as many as people see of a live run

    /// A recording that says more at once is refused.
    static final int MOST_MESSAGES = 200_000;

    static final long MOST_BYTES = 256L << 20;

    private final LinkedHashMap<String, Raw> messages; // in the order in which they came first
    private final LinkedHashMap<String, Speech> speeches;
    private long bytes;

    /// A message as it is in the file. The same object for as long as it is the newest.
    ///
    /// @param time when it was true, in ns
    record Raw(long time, byte[] data) {
        ByteBuffer buffer() {
            return ByteBuffer.wrap(data).order(ByteOrder.LITTLE_ENDIAN);
        }
    }

    /// What an agent has said.
    ///
    /// @param last newest few, oldest first
    /// @param time of the last, as a recording has it [ns]; empty when it has said nothing
    record Speech(long sent, List<String> last, Optional<Long> time) {
        private static final Speech NONE = new Speech(0, List.of(), Optional.empty());

        Speech {
            last = List.copyOf(last);
        }

        /// At most.
        private long bytes() {
            return last.stream().mapToLong(words -> 2L * words.length()).sum();
        }

        private Speech and(String words, long now) {
            var all = new ArrayList<>(last);
            all.add(words);
            return new Speech(
                    sent + 1, all.subList(Math.max(0, all.size() - LAST_WORDS), all.size()), Optional.of(now));
        }
    }

    NewestRecords() {
        messages = new LinkedHashMap<>();
        speeches = new LinkedHashMap<>();
    }

    private NewestRecords(NewestRecords other) {
        messages = new LinkedHashMap<>(other.messages);
        speeches = new LinkedHashMap<>(other.speeches);
        bytes = other.bytes;
    }

    NewestRecords copy() {
        return new NewestRecords(this);
    }

    /// @return whether there is room for it
    boolean put(String key, long time, ByteBuffer data) {
        byte[] own = new byte[data.remaining()];
        data.duplicate().get(own);
        Raw before = messages.put(key, new Raw(time, own));
        bytes += own.length - (before == null ? 0 : before.data().length);
        return bytes <= MOST_BYTES && messages.size() <= MOST_MESSAGES;
    }

    /// @param time as a recording has it [ns]
    /// @return whether there is room for it
    boolean said(String agent, String words, long time) {
        Speech before = speeches.getOrDefault(agent, Speech.NONE);
        Speech after = before.and(words, time);
        speeches.put(agent, after);
        bytes += after.bytes() - before.bytes();
        return bytes <= MOST_BYTES && speeches.size() <= MOST_MESSAGES;
    }

    Speech speech(String agent) {
        return speeches.getOrDefault(agent, Speech.NONE);
    }

    Map<String, Raw> messages() {
        return messages;
    }
}
