package rsal.ros2.link;

import java.nio.ByteBuffer;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.InvalidCdr;

/// Takes messages from the link's thread to the run's. Where the run is slow, the newest ones stay.
///
/// @param <M> a message
public final class Inbox<M> implements Consumer<ByteBuffer> {
    private final int capacity;
    private final Decoder<M> decoder;
    private final Executor run;
    private final Consumer<M> receiver;
    private final Deque<M> waiting = new ArrayDeque<>();
    private boolean isScheduled; // to be delivered

    /// Reads a message.
    ///
    /// @param <M> a message
    public interface Decoder<M> {
        M read(CdrReader bytes) throws InvalidCdr;
    }

    /// @param capacity how many messages wait at most
    /// @param run whose thread receives them
    public Inbox(int capacity, Decoder<M> decoder, Executor run, Consumer<M> receiver) {
        this.capacity = capacity;
        this.decoder = decoder;
        this.run = run;
        this.receiver = receiver;
    }

    @Override
    public void accept(ByteBuffer bytes) {
        M message;
        try {
            message = decoder.read(CdrReader.of(bytes));
        } catch (InvalidCdr e) {
            return; // a malformed message harms nobody
        }
        boolean isFirst;
        synchronized (waiting) {
            isFirst = !isScheduled;
            isScheduled = true;
            if (waiting.size() == capacity) {
                waiting.removeFirst();
            }
            waiting.addLast(message);
        }
        if (isFirst) {
            run.execute(this::deliver);
        }
    }

    /// One at a time, so that a receiver that fails harms none of the others.
    private void deliver() {
        M message;
        synchronized (waiting) {
            message = waiting.pollFirst();
        }
        try {
            if (message != null) {
                receiver.accept(message);
            }
        } finally {
            boolean isMore;
            synchronized (waiting) {
                isMore = !waiting.isEmpty();
                isScheduled = isMore;
            }
            if (isMore) {
                run.execute(this::deliver);
            }
        }
    }
}
