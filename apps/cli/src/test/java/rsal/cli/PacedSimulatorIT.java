package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

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
import rsal.data.Pose2d;
import rsal.engine.LiveRun;
import rsal.engine.RunBuilder;
import rsal.engine.report.Answer;
import rsal.engine.report.Snapshot;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;
import rsal.system.BridgeProvider;
import rsal.system.CommandTimeout;
import rsal.testkit.LongTest;

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

    /// Drives, and takes 30 ms of real time in each 50 ms of its own; 1.2 s once in 2 s.
    private static final String SLOW = """
            import java.time.Duration;
            import java.util.concurrent.locks.LockSupport;
            import rsal.agent.Agent;
            import rsal.agent.AgentContext;
            import rsal.data.Twist2d;
            import rsal.device.DriveBase;

            public final class Slow implements Agent {
                @Override
                public void start(AgentContext self) {
                    DriveBase base = self.robot().orElseThrow().require(DriveBase.class);
                    self.scheduler().every(Duration.ofMillis(50), () -> LockSupport.parkNanos(30_000_000));
                    self.scheduler().every(Duration.ofSeconds(2), () -> LockSupport.parkNanos(1_200_000_000));
                    self.scheduler().every(Duration.ofMillis(100), () -> base.command(Twist2d.drive(0.2, 0)));
                }
            }
            """;

    private final int domain = (int) (1 + (ProcessHandle.current().pid() + 61) % 100); // no other test's

    @TempDir
    private Path folder;

    private LiveRun simulator;
    private LiveRun run;

    private RunBuilder run(String name, String text) throws IOException {
        Path file = Files.writeString(folder.resolve(name + ".yaml"), text);
        return LiveRun.of(Scenario.load(file.toString()).plan(RunOptions.NONE));
    }

    @BeforeEach
    void start() throws Exception {
        Files.writeString(folder.resolve("Slow.java"), SLOW);
        simulator = run("simulator", SIMULATOR).paused().start(); // until it has a bridge
        BridgeProvider ros = ServiceLoader.load(BridgeProvider.class).stream()
                .map(ServiceLoader.Provider::get)
                .filter(each -> each.key().equals("ros2"))
                .findFirst()
                .orElseThrow();
        var at = new InetSocketAddress(InetAddress.getLoopbackAddress(), 7400 + 250 * domain);
        assertThat(simulator
                        .operator()
                        .bridge(ros, at, Optional.of(CommandTimeout.USUAL), true)
                        .toCompletableFuture()
                        .get(30, TimeUnit.SECONDS))
                .isInstanceOf(Answer.Bridged.class);
        simulator.resume();
        run = run(
                        "follower",
                        SIMULATOR.replace("simulator", "follower").replace("speed: max", "mode: wall")
                                + """
                mrs: {use: ros2, useSimTime: true, armed: true, wait: 10, domain: %d}
                agents: {slow: {type: Slow.java, robot: r}}
                """.formatted(domain))
                .start();
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

    /// Neither the simulator nor the follower stops the robot, though they wait for longer than the half second that a
    /// command holds.
    @Test
    @LongTest
    void aStallOfTheFollowerStopsNoRobot() throws Exception {
        await(run, snapshot -> snapshot.time().compareTo(Duration.ofSeconds(2)) > 0);
        Snapshot first = simulator.freshSnapshot().toCompletableFuture().join();
        Snapshot last = await(
                simulator, snapshot -> snapshot.time().compareTo(first.time().plusSeconds(6)) > 0);
        double seconds = last.time().minus(first.time()).toMillis() / 1e3;
        double driven = where(first).distanceTo(where(last));
        assertThat(driven).isCloseTo(0.2 * seconds, within(0.02)); // as poses are those of the last step
    }

    private static Pose2d where(Snapshot now) {
        return now.robots().getFirst().truth().orElseThrow();
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
