package rsal.server.http;

import java.util.concurrent.Semaphore;
import java.util.function.Supplier;
import rsal.server.message.Refusal;

/// Work that takes a while and that everybody who can reach the port may ask for, without a token: few wait for it at a
/// time, as all threads that answer are needed for others, also for an emergency stop. May be called from any thread.
public final class FewAtOnce {
    private static final int MOST = 4; // of sixteen threads

    private final Semaphore asking = new Semaphore(MOST);
    private final String about;

    /// @param about what is asked for: `earlier sweeps`
    public FewAtOnce(String about) {
        this.about = about;
    }

    /// @throws Refusal when others are asking
    public <T> T ask(Supplier<T> work) {
        if (!asking.tryAcquire()) {
            throw new Refusal(409, "Others request %s at the same time. Try again in a moment.".formatted(about));
        }
        try {
            return work.get();
        } finally {
            asking.release();
        }
    }
}
