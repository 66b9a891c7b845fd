package rsal.cli.terminal;

import java.util.concurrent.CountDownLatch;

/// Closes what runs when a signal ends the process, and gives up on what takes too long: Ctrl-C ends within 2 s.
public final class ClosedAtExit {
    private static final long PATIENCE_MILLIS = 1_500;

    private volatile boolean ending;

    /// @param running closing it twice must do nothing
    public ClosedAtExit(AutoCloseable running) {
        Runtime.getRuntime()
                .addShutdownHook(new Thread(
                        () -> {
                            ending = true;
                            closeInTime(running);
                        },
                        "shutdown"));
    }

    private static void closeInTime(AutoCloseable running) {
        Thread closer = Thread.ofPlatform().name("closer").daemon().start(() -> {
            try {
                running.close();
            } catch (Exception e) {
                System.getLogger("rsal.cli").log(System.Logger.Level.WARNING, "Closing failed.", e);
            }
        });
        try {
            closer.join(PATIENCE_MILLIS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /// Never returns when a signal came first: what ended only because of it is no result.
    public void checkNoSignal() throws InterruptedException {
        if (ending) {
            new CountDownLatch(1).await(); // the JVM is going down
        }
    }
}
