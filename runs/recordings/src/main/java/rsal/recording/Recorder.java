package rsal.recording;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;
import java.util.Set;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import rsal.engine.report.RunObserver;
import rsal.engine.report.RunResult;
import rsal.mcap.McapWriter;
import rsal.recording.Backlog.Entry;

/// Records a run: what its witness is told on the run's thread is written on one of its own, `recorder`.
///
/// When writing fails, the run goes on and nothing more is recorded ([#failure]).
public final class Recorder implements AutoCloseable {
    private final Backlog backlog;
    private final McapWriter file;
    private final Encoder encoder;
    private final Thread writer;
    private volatile @Nullable RunResult result;
    private volatile @Nullable IOException failure;
    private volatile long bytes; // in the file

    /// The results of recordings so far.
    ///
    /// @param bytes that were written
    /// @param dropped states of the run that were not, as the file was too slow
    /// @param failed how many recordings are not whole
    public record Tally(long bytes, long dropped, int failed) {
        /// Of no recording.
        public static final Tally NONE = new Tally(0, 0, 0);

        /// Of these and those together.
        public Tally plus(Tally other) {
            return new Tally(bytes + other.bytes, dropped + other.dropped, failed + other.failed);
        }
    }

    private Recorder(McapWriter file, Encoder encoder, Backlog.Behind behind) {
        this.file = file;
        this.encoder = encoder;
        this.backlog = new Backlog(behind);
        this.writer = Thread.ofPlatform().name("recorder").daemon().unstarted(this::write);
    }

    /// Begins a recording.
    ///
    /// @param force whether a file that is there may be lost
    /// @param behind what happens when the run is faster than the file
    /// @param clock real time, by which what is open grows old, in ns
    /// @throws java.nio.file.FileAlreadyExistsException when it is there and may not
    /// @throws IOException when it can't be written
    public static Recorder begin(Path path, boolean force, Origin origin, Backlog.Behind behind, LongSupplier clock)
            throws IOException {
        var options = force
                ? Set.of(StandardOpenOption.WRITE, StandardOpenOption.CREATE, StandardOpenOption.TRUNCATE_EXISTING)
                : Set.of(StandardOpenOption.WRITE, StandardOpenOption.CREATE_NEW);
        FileChannel channel = FileChannel.open(path, options);
        try {
            var file = new McapWriter(channel, origin.program(), clock);
            var encoder = new Encoder(new McapSink(file), origin.start());
            origin.write(file);
            encoder.map(origin.plan().map());
            file.flush();
            var recorder = new Recorder(file, encoder, behind);
            recorder.writer.start();
            return recorder;
        } catch (IOException | RuntimeException e) {
            channel.close();
            throw e;
        }
    }

    /// Whom the run is to tell.
    public RunObserver observer() {
        return backlog;
    }

    /// The run has ended. To be called before [#close], for how it ended to be in the file.
    public void ended(RunResult how) {
        result = how;
    }

    /// States of the run that were not written as the file was too slow.
    public long dropped() {
        return backlog.dropped();
    }

    /// The result so far. From any thread, without waiting for the file.
    public Tally tally() {
        return new Tally(bytes, dropped(), failure().isPresent() ? 1 : 0);
    }

    /// Why nothing more was written; empty while all is well.
    public Optional<IOException> failure() {
        return Optional.ofNullable(failure);
    }

    /// On the recorder's thread.
    private void write() {
        try (file) {
            while (!backlog.isOver()) {
                Optional<Entry> next = backlog.take();
                if (next.isPresent()) {
                    next.get().write(encoder);
                }
                file.tick();
                bytes = file.size();
            }
            RecordedOutcome.write(file, Optional.ofNullable(result), dropped());
        } catch (IOException e) {
            fail(e);
        } catch (RuntimeException e) {
            fail(new IOException("Recording failed: " + e, e));
        }
        bytes = file.size();
    }

    private void fail(IOException why) {
        failure = why;
        backlog.abandon();
    }

    /// Writes what waits, and the end of the file; then it is whole. Closing twice does nothing.
    @Override
    public void close() {
        backlog.end();
        try {
            writer.join();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
