package rsal.recording;

import java.util.concurrent.CountDownLatch;
import java.util.function.LongSupplier;

/// A clock that holds up whoever asks it, as a slow disk does.
final class StuckClock implements LongSupplier {
    private volatile CountDownLatch latch = new CountDownLatch(0);

    void stick() {
        latch = new CountDownLatch(1);
    }

    void letGo() {
        latch.countDown();
    }

    @Override
    public long getAsLong() {
        try {
            latch.await();
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
        return 0;
    }
}
