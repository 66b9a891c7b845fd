package rsal.python;

import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/// The time in which a process has to answer. When it is over, the process is ended with those that it has started, so
/// that who reads from it goes on. Close it when there is an answer.
///
/// By the clock of the machine: a process that hangs does so in real time.
final class AnswerTime implements AutoCloseable {
    private final CountDownLatch answered = new CountDownLatch(1);
    private final Duration limit;
    private volatile boolean over;

    private AnswerTime(Duration limit) {
        this.limit = limit;
    }

    /// Begins now.
    static AnswerTime of(Process process, Duration limit) {
        var time = new AnswerTime(limit);
        Thread.ofVirtual().name("python-answer").start(() -> time.await(process));
        return time;
    }

    private void await(Process process) {
        try {
            if (!answered.await(limit.toMillis(), TimeUnit.MILLISECONDS)) {
                over = true;
                // Itself first, or it would go on once its descendants have ended. These hold its pipes, too.
                Stream.concat(Stream.of(process.toHandle()), process.descendants())
                        .toList()
                        .forEach(ProcessHandle::destroyForcibly);
            }
        } catch (InterruptedException _) {
            Thread.currentThread().interrupt();
        }
    }

    /// Whether it was over before there was an answer.
    boolean isOver() {
        return over;
    }

    /// For people, when it was over.
    String words() {
        return "it did not answer within %d s".formatted(limit.toSeconds());
    }

    @Override
    public void close() {
        answered.countDown();
    }
}
