package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
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

/// Two runs in one process, which DDS joins: a simulator that publishes its robot and `/clock`, and a run that has its
/// time.
@Timeout(value = 3, unit = TimeUnit.MINUTES)
class SimulatorTimeIT {
    private static final Duration CLOSE = Duration.ofMillis(300); // two looks at two runs, on a busy machine
    private static final String SIMULATOR = """
            rsal: 1
            scenario: simulator
            world: {map: office}
            robots:
              r: {model: pioneer2dx, pose: [-12, -1, 180]}
            """;

    private final int domain = (int) (1 + (ProcessHandle.current().pid() + 71) % 100); // no other test's

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
        simulator = start("simulator", SIMULATOR);
        BridgeProvider ros = ServiceLoader.load(BridgeProvider.class).stream()
                .map(ServiceLoader.Provider::get)
                .filter(each -> each.key().equals("ros2"))
                .findFirst()
                .orElseThrow();
        var at = new InetSocketAddress(InetAddress.getLoopbackAddress(), 7400 + 250 * domain);
        assertThat(simulator.operator().bridge(ros, at).toCompletableFuture().get(30, TimeUnit.SECONDS))
                .isInstanceOf(Answer.Bridged.class);
        run = start("follower", SIMULATOR.replace("simulator", "follower") + """
                mrs: {use: ros2, useSimTime: true, armed: true, wait: 3, domain: %d}
                run: {clock: {mode: wall}}
                """.formatted(domain));
        await(run, snapshot -> !snapshot.robots().isEmpty());
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

    private static void pauseFor(Duration time) throws InterruptedException {
        TimeUnit.NANOSECONDS.sleep(time.toNanos());
    }

    private void assertThatTheyGoTogether() throws InterruptedException {
        Duration simulated = time(simulator);
        Duration own = time(run);
        pauseFor(Duration.ofSeconds(2));
        simulated = time(simulator).minus(simulated);
        own = time(run).minus(own);
        assertThat(own.minus(simulated).abs()).isLessThan(CLOSE);
    }

    @Test
    void theRunStandsAndHurriesWithItsSimulator() throws Exception {
        assertThatTheyGoTogether();
        simulator.pause();
        await(simulator, Snapshot::paused);
        pauseFor(CLOSE); // messages on their way
        Duration standing = time(run);
        pauseFor(Duration.ofSeconds(1));
        assertThat(time(run)).isEqualTo(standing);
        simulator.resume();
        simulator.speed(3);
        Duration before = time(simulator);
        long began = System.nanoTime();
        assertThatTheyGoTogether();
        double seconds = (System.nanoTime() - began) / 1e9;
        assertThat(time(simulator).minus(before).toMillis() / 1e3 / seconds).isGreaterThan(1.5); // it did hurry
    }

    @Test
    void aSimulatorThatLeavesEndsTheRun() {
        simulator.stop();
        assertThatThrownBy(() -> run.result().toCompletableFuture().get(90, TimeUnit.SECONDS))
                .hasMessageContaining("The run can't go on without time. Nobody publishes '/clock'");
    }
}
