package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import rsal.bare.BareSystem;
import rsal.bare.Life;

/// What a multi-agent system without us owes to benchmarks, so that they count what they say.
public abstract class BareSystemContract {
    private static final int AGENTS = 5;
    private static final int OTHERS = AGENTS - 1;

    protected abstract BareSystem system();

    @Test
    void allHearAllAgainAndAgain() throws InterruptedException {
        var heard = new CountDownLatch(AGENTS * OTHERS * 10);
        try (var platform = system().start()) {
            platform.start(AGENTS, new Life(Duration.ofMillis(20), () -> {}, heard::countDown));
            await(heard);
        }
    }

    @Test
    void eachHearsWhatTheOthersSayAndNothingElse() throws InterruptedException {
        var begun = new CountDownLatch(AGENTS);
        var first = new CountDownLatch(AGENTS * OTHERS * 3);
        var second = new CountDownLatch(AGENTS * OTHERS * 5);
        var heard = new AtomicInteger();
        try (var platform = system().start()) {
            platform.start(AGENTS, new Life(Duration.ZERO, begun::countDown, () -> {
                heard.incrementAndGet();
                first.countDown();
                second.countDown();
            }));
            await(begun);
            platform.say(3);
            await(first);
            assertThat(heard).hasValue(AGENTS * OTHERS * 3);
            platform.say(2);
            await(second);
            assertThat(heard).hasValue(AGENTS * OTHERS * 5);
        }
    }

    @Test
    void aManagerCallsForProposalsAgainAndAgain() throws InterruptedException {
        var ended = new CountDownLatch(10);
        try (var platform = system().start()) {
            platform.contract(AGENTS, ended::countDown);
            await(ended);
        }
    }

    private static void await(CountDownLatch latch) throws InterruptedException {
        assertThat(latch.await(30, TimeUnit.SECONDS)).isTrue();
    }
}
