package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rsal.engine.LiveRun;
import rsal.engine.report.Answer;
import rsal.engine.report.Snapshot;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;
import rsal.system.BridgeProvider;

/// A simulator that goes as fast as the run which follows its time over DDS, though that run is slow.
@Timeout(value = 3, unit = TimeUnit.MINUTES)
class PacedSimulatorIT {
    private static final Duration BOUND = Duration.ofMillis(10); // of simulated time, between two messages of /clock
    private static final String SIMULATOR = """
            rsal: 1
            scenario: simulator
            world: {map: office}
            robots:
              r: {model: pioneer2dx, pose: [-12, -1, 180]}
            run: {clock: {speed: max}}
            """;

    /// Takes 30 ms of real time in each 50 ms of its own.
    private static final String SLOW = """
            import java.time.Duration;
            import java.util.concurrent.locks.LockSupport;
            import rsal.agent.Agent;
            import rsal.agent.AgentContext;

            public final class Slow implements Agent {
                @Override
                public void start(AgentContext self) {
                    self.scheduler().every(Duration.ofMillis(50), () -> LockSupport.parkNanos(30_000_000));
                }
            }
            """;

    private final int domain = (int) (1 + (ProcessHandle.current().pid() + 61) % 100); // no other test's

    @TempDir
    private Path folder;

    private LiveRun simulator;
    private LiveRun run;

    private LiveRun start(String name, String text) throws IOException {
        Path file = Files.writeString(folder.resolve(name + ".yaml"), text);
        return LiveRun.start(Scenario.load(file.toString()).plan(RunOptions.NONE));
    }

    @BeforeEach
    void start() throws Exception {
        Files.writeString(folder.resolve("Slow.java"), SLOW);
        simulator = start("simulator", SIMULATOR);
        BridgeProvider ros = ServiceLoader.load(BridgeProvider.class).stream()
                .map(ServiceLoader.Provider::get)
                .filter(each -> each.key().equals("ros2"))
                .findFirst()
                .orElseThrow();
        var at = new InetSocketAddress(InetAddress.getLoopbackAddress(), 7400 + 250 * domain);
        simulator.pause(); // at this speed, it would be far before it has a bridge
        assertThat(simulator
                        .operator()
                        .bridge(ros, at, Optional.empty(), true)
                        .toCompletableFuture()
                        .get(30, TimeUnit.SECONDS))
                .isInstanceOf(Answer.Bridged.class);
        simulator.resume();
        run = start(
                "follower",
                SIMULATOR.replace("simulator", "follower").replace("speed: max", "mode: wall") + """
                mrs: {use: ros2, useSimTime: true, armed: true, wait: 10, domain: %d}
                agents: {slow: {type: Slow.java, robot: r}}
                """.formatted(domain));
        await(run, snapshot -> !snapshot.agents().isEmpty());
    }

    @AfterEach
    void close() {
        run.close();
        simulator.close();
    }

    private static Snapshot await(LiveRun which, Predicate<Snapshot> wanted) throws Exception {
        return which.when(wanted).toCompletableFuture().get(60, TimeUnit.SECONDS);
    }

    private static Duration time(LiveRun which) {
        return which.freshSnapshot().toCompletableFuture().join().time();
    }

    /// The run began later: by how much, says what fits all looks at both.
    @Test
    void theSimulatorIsNeverFurtherAheadThanOneMessageOfItsClock() throws Exception {
        Duration earliest = Duration.ofDays(-1);
        Duration latest = Duration.ofDays(1);
        Duration from = time(run);
        long began = System.nanoTime();
        for (int i = 0; i < 40; i++) {
            Duration before = time(simulator);
            Duration own = time(run);
            Duration after = time(simulator);
            earliest = max(earliest, before.minus(own));
            latest = min(latest, after.minus(own));
            TimeUnit.MILLISECONDS.sleep(40);
        }
        // between two looks, it may go on by a message that it has published and the run has not yet heard of
        assertThat(earliest.minus(latest)).isLessThanOrEqualTo(BOUND.multipliedBy(2));
        double seconds = (System.nanoTime() - began) / 1e9;
        Duration passed = time(run).minus(from);
        assertThat(passed.toMillis() / 1e3).isBetween(0.2, 1.7 * seconds); // no faster than its agent: 50 ms in 30
    }

    @Test
    void aFollowerThatLeavesSetsItFree() throws Exception {
        run.stop();
        run.result().toCompletableFuture().get(30, TimeUnit.SECONDS);
        Duration from = time(simulator);
        long began = System.nanoTime();
        await(simulator, snapshot -> snapshot.time().compareTo(from.plusSeconds(2)) > 0);
        double seconds = (System.nanoTime() - began) / 1e9;
        assertThat(seconds).isBetween(1.5, 30.0); // now at real time
    }

    private static Duration max(Duration one, Duration other) {
        return one.compareTo(other) > 0 ? one : other;
    }

    private static Duration min(Duration one, Duration other) {
        return one.compareTo(other) < 0 ? one : other;
    }
}
