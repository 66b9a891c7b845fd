package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rsal.scenario.RunOptions;
import rsal.system.Bridge;
import rsal.system.BridgeContext;
import rsal.system.BridgeProvider;
import rsal.system.RunControl;
import rsal.time.Scheduler;

/// A run that goes on as programs behind a bridge let it.
@Timeout(60)
class PacedRunTest {
    private static final Duration GRAIN = Duration.ofMillis(10);
    private static final long FOREVER = Duration.ofDays(1).toNanos();

    @TempDir
    private Path folder;

    private final CompletableFuture<BridgeContext> opened = new CompletableFuture<>();
    private final AtomicReference<Bridge.Pace> pace = new AtomicReference<>(Bridge.Pace.AWAITED);
    private volatile long allowed; // simulated time until which the program follows [ns]
    private volatile long furthest; // simulated time at which the run asked [ns]
    private volatile long longest; // simulated time between two questions [ns]
    private LiveRun run;
    private RunControl control;

    /// Lets the run go on until some time.
    private final class Following extends IdleBridge implements BridgeProvider {
        private Scheduler scheduler;
        private long begun;

        @Override
        public String key() {
            return "following";
        }

        @Override
        public String description() {
            return "Lets the run go on until some time.";
        }

        @Override
        public int defaultPort() {
            return 7000;
        }

        @Override
        public Bridge open(InetSocketAddress at, BridgeContext context, Scheduler time) {
            scheduler = time;
            begun = time.instant().toEpochMilli();
            opened.complete(context);
            return this;
        }

        @Override
        public Optional<Duration> grain() {
            return Optional.of(GRAIN);
        }

        @Override
        public Pace pace() {
            long now = Duration.ofMillis(scheduler.instant().toEpochMilli() - begun)
                    .toNanos();
            longest = Math.max(longest, now - furthest);
            furthest = now;
            boolean mayGoOn = now < allowed;
            return mayGoOn ? Pace.FOLLOWED : pace.get();
        }
    }

    @BeforeEach
    void start() {
        run = LiveRun.of(Runs.plan(
                        folder,
                        Runs.TWO_WANDERERS.replace("time >= 20", "time >= 2000"),
                        RunOptions.NONE.withSpeed(Double.POSITIVE_INFINITY)))
                .paused()
                .start();
        run.operator()
                .bridge(
                        new Following(),
                        new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
                        Optional.empty(),
                        true);
        BridgeContext context = await(opened);
        assertThat(context.isPaced()).isTrue();
        assertThat(time()).as("it has waited for its bridge").isZero();
        control = context.control().orElseThrow();
        run.resume();
    }

    @AfterEach
    void stop() {
        run.close();
    }

    private static <T> T await(CompletableFuture<T> answer) {
        return answer.orTimeout(20, TimeUnit.SECONDS).join();
    }

    private static void pauseFor(long milliseconds) throws InterruptedException {
        TimeUnit.MILLISECONDS.sleep(milliseconds);
    }

    private Duration time() {
        return await(run.freshSnapshot().toCompletableFuture()).time();
    }

    private void awaitTime(Duration time) throws InterruptedException {
        while (furthest < time.toNanos()) {
            pauseFor(2);
        }
    }

    @Test
    void itIsNeverFurtherThanTheProgramLetsIt() throws Exception {
        for (int i = 1; i <= 40; i++) {
            allowed = GRAIN.toNanos() * i;
            awaitTime(GRAIN.multipliedBy(i));
            pauseFor(i % 5);
            assertThat(furthest).isEqualTo(allowed);
        }
        assertThat(longest).isEqualTo(GRAIN.toNanos());
    }

    @Test
    void peopleAreAnsweredWhileItWaits() throws Exception {
        allowed = GRAIN.multipliedBy(5).toNanos();
        awaitTime(GRAIN.multipliedBy(5));
        var answered = new CompletableFuture<Boolean>();
        control.execute(() -> answered.complete(true));
        assertThat(await(answered)).isTrue();
        Duration then = time();
        pauseFor(50);
        assertThat(time()).isEqualTo(then);
        run.stop();
        assertThat(Runs.result(run).outcome()).isEqualTo("stopped");
    }

    /// Steps keep their length, so that a run repeats and programs can count them.
    @Test
    void aRunIsPausedBetweenSteps() throws Exception {
        allowed = GRAIN.multipliedBy(3).toNanos();
        awaitTime(GRAIN.multipliedBy(3));
        run.pause();
        allowed = FOREVER;
        await(run.when(now -> now.paused() && isBetweenSteps(now.time())).toCompletableFuture());
        Duration then = time();
        pauseFor(50);
        assertThat(time()).isEqualTo(then);
        var ended = new CompletableFuture<Long>();
        control.execute(() -> control.step(4).result().thenAccept(ended::complete));
        assertThat(await(ended)).isEqualTo(4);
        assertThat(time()).isEqualTo(then.plus(run.plan().step().multipliedBy(4)));
    }

    /// It may be the one that pauses the run, and waits for the answer before it goes on itself.
    @Test
    void aPausedRunDoesNotWaitForTheProgram() throws Exception {
        allowed = GRAIN.multipliedBy(3).toNanos();
        awaitTime(GRAIN.multipliedBy(3));
        var standing = new CompletableFuture<Void>();
        control.execute(() -> control.pause().thenAccept(standing::complete));
        await(standing);
        assertThat(isBetweenSteps(time())).isTrue();
        Duration then = time();
        pauseFor(50);
        assertThat(time()).isEqualTo(then);
    }

    private boolean isBetweenSteps(Duration time) {
        return time.toNanos() % run.plan().step().toNanos() == 0;
    }

    @Test
    void withoutSuchAProgramItGoesAtRealTime() throws Exception {
        pace.set(Bridge.Pace.UNFOLLOWED);
        long began = System.nanoTime();
        long from = furthest;
        pauseFor(600);
        long simulated = furthest - from;
        assertThat(simulated).isPositive().isLessThanOrEqualTo(System.nanoTime() - began + GRAIN.toNanos());
        allowed = FOREVER; // one has come, which is fast
        began = System.nanoTime();
        from = furthest;
        awaitTime(Duration.ofNanos(from).plusSeconds(20));
        assertThat(System.nanoTime() - began).isLessThan(Duration.ofSeconds(15).toNanos());
    }
}
