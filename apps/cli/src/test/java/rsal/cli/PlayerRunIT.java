package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.parallel.ExecutionMode.CONCURRENT;

import java.io.BufferedReader;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import rsal.data.Pose2d;
import rsal.engine.LiveRun;
import rsal.engine.report.RobotView;
import rsal.engine.report.RunEvent;
import rsal.engine.report.RunResult;
import rsal.engine.report.Snapshot;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;
import rsal.testkit.LongTest;
import rsal.testkit.Trials;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/// Agents in one process, robots in another, as with real ones: nothing is shared but sockets. They follow real time
/// and mostly wait, so that some go on at once.
@Timeout(value = 5, unit = TimeUnit.MINUTES)
class PlayerRunIT {
    private static final int COLLECT_SEED = 1;
    private static final Path ROOM = Path.of("../../docs/examples/room").toAbsolutePath();

    @TempDir
    Path folder;

    /// Serves a scenario's robots, which nobody drives there.
    ///
    /// @param port of the first; 0 for any
    private Process serve(List<String> arguments, int port) throws Exception {
        var all = new ArrayList<>(List.of("bridge", "player"));
        all.addAll(arguments);
        all.addAll(List.of("--no-agents", "--port", Integer.toString(port), "--json"));
        return new Rsal(folder).start(all.toArray(String[]::new));
    }

    /// Of those robots, by their numbers from 0.
    private static String servers(BufferedReader reported, int... robots) throws Exception {
        Set<String> ports = new LinkedHashSet<>();
        JsonNode json = JsonMapper.shared().readTree(reported.readLine());
        json.get("offers")
                .forEach(offer -> ports.add("localhost:" + offer.get("port").asInt()));
        List<String> all = List.copyOf(ports);
        return Arrays.stream(robots).mapToObj(all::get).collect(Collectors.joining(","));
    }

    /// Has agents drive robots that another process serves.
    ///
    /// @param robots which of those are the run's real ones, by their numbers from 0
    /// @param arguments of the scenario
    /// @return what came of it
    private JsonNode run(String scenario, String configuration, int seed, int[] robots, List<String> arguments)
            throws Exception {
        var served = new ArrayList<>(List.of(scenario, "--seed", Integer.toString(seed)));
        served.addAll(arguments);
        Process real = serve(served, 0);
        try (BufferedReader reported = real.inputReader()) {
            var driven =
                    new ArrayList<>(List.of("run", scenario + ":" + configuration, "--headless", "--arm", "--json"));
            driven.addAll(List.of("--seed", Integer.toString(seed), "--set", "servers=" + servers(reported, robots)));
            driven.addAll(arguments);
            Process agents = new Rsal(folder).start(driven.toArray(String[]::new));
            try (BufferedReader out = agents.inputReader()) {
                JsonNode result = JsonMapper.shared().readTree(out.readLine());
                assertThat(agents.waitFor()).isZero();
                assertThat(result.get("outcome").asString()).isEqualTo("success");
                return result.get("metrics");
            }
        } finally {
            Ended.signal("INT", real);
            assertThat(real.waitFor()).isEqualTo(130);
        }
    }

    /// Of the prey and two hunters all are real, or the prey and a hunter, or a hunter alone.
    @Trials({"mixed, 0 1", "real, 0 1 2", "virtual-prey, 1"})
    @Execution(CONCURRENT)
    @LongTest
    void huntersCatchTheirPrey(String configuration, String real) throws Exception {
        int[] robots =
                Arrays.stream(real.split(" ")).mapToInt(Integer::parseInt).toArray();
        JsonNode metrics = run("hunt-and-prey", configuration, 7, robots, List.of());
        assertThat(metrics.get("captureTime").asDouble()).isBetween(5.0, 290.0);
    }

    /// What it grips is a can of the other process; what counts is a simulated one.
    @Test
    @LongTest
    @Execution(CONCURRENT)
    void aRealCollectorBringsWhatASimulatedExplorerFinds() throws Exception {
        JsonNode metrics = run(
                "find-and-collect",
                "mixed",
                COLLECT_SEED,
                new int[] {1},
                List.of("--set", "collectors=1", "--set", "cans=1"));
        assertThat(metrics.get("collected").asDouble()).isEqualTo(1);
    }

    /// The robots' simulation is gone with their server; a new one has them where they began.
    @Test
    @Execution(CONCURRENT)
    @LongTest
    void aHuntGoesOnWhenItsServersWereKilledAndAreBack() throws Exception {
        var served = List.of("hunt-and-prey", "--seed", "7");
        int port = threeFree();
        Process robots = serve(served, port);
        String servers;
        try (BufferedReader reported = robots.inputReader()) {
            servers = servers(reported, 0, 1, 2);
        }
        var options = RunOptions.NONE.withConfiguration("real").withSeed(7).withArguments(Map.of("servers", servers));
        try (LiveRun hunt = LiveRun.start(Scenario.load("hunt-and-prey").plan(options))) {
            hunt.operator().rearm().toCompletableFuture().join();
            until(hunt, event -> event.kind().equals("message"), 1);
            Ended.signal("KILL", robots);
            until(hunt, event -> event.kind().equals("fault") && event.text().startsWith("is gone: "), 3);
            until(
                    hunt,
                    event -> event.kind().equals("health") && event.subject().endsWith("/base"),
                    3);
            robots = serve(served, port);
            until(hunt, event -> event.kind().equals("run") && event.text().equals("is there"), 3);
            RunResult result = hunt.result().toCompletableFuture().get(4, TimeUnit.MINUTES);
            assertThat(result.outcome()).isEqualTo("success");
        } finally {
            robots.destroy();
        }
    }

    /// Who is nearer goes there, whichever world it is in.
    @Test
    @LongTest
    @Execution(CONCURRENT)
    void robotsOfBothWorldsSpread() throws Exception {
        JsonNode metrics = run("distribution", "mixed", 3, new int[] {0, 1, 2}, List.of());
        assertThat(metrics.get("arrived").asDouble()).isEqualTo(6);
        assertThat(metrics.get("collisions").asDouble()).isZero();
    }

    /// The example: amcl, vfh and wavefront are the server's, as its file says. An emergency stop holds it on
    /// the way, and it goes on when it may.
    @Test
    @Execution(CONCURRENT)
    void aRobotGoesByItsServersOwnLocalizerAndPlanner() throws Exception {
        Process robots = serve(List.of(ROOM.resolve("room.cfg").toString()), 0);
        String servers;
        try (BufferedReader reported = robots.inputReader()) {
            servers = servers(reported, 0);
        }
        var options = RunOptions.NONE.withArguments(Map.of("servers", servers));
        var scenario = Scenario.load(ROOM.resolve("own-planner.yaml").toString());
        try (LiveRun run = LiveRun.start(scenario.plan(options))) {
            var goal = new Pose2d(2.5, -2, 0); // on the other side of the wall
            run.operator().rearm().toCompletableFuture().join();
            run.operator().goTo("robot-1", goal).toCompletableFuture().join();
            until(run, robot -> robot.estimate().isPresent() && velocity(robot) > 0.2);
            run.operator().estop().toCompletableFuture().join();
            until(run, robot -> velocity(robot) == 0);
            Pose2d there = until(run, robot -> velocity(robot) == 0)
                    .estimate()
                    .orElseThrow()
                    .value()
                    .mapFromBase();
            assertThat(there.distanceTo(goal)).isGreaterThan(2);
            run.operator().rearm().toCompletableFuture().join();
            until( // by itself
                    run,
                    robot -> robot.estimate()
                            .filter(estimate -> estimate.value().mapFromBase().distanceTo(goal) < 0.5)
                            .isPresent());
        } finally {
            robots.destroy();
        }
    }

    /// Forwards [m/s].
    private static double velocity(RobotView robot) {
        return robot.odometry()
                .map(odometry -> odometry.value().velocity().vx())
                .orElse(Double.NaN);
    }

    /// The first robot once it is as it should be.
    private static RobotView until(LiveRun run, Predicate<RobotView> isSo) {
        return run.when(snapshot -> first(snapshot).filter(isSo).isPresent())
                .thenApply(snapshot -> first(snapshot).orElseThrow())
                .toCompletableFuture()
                .join();
    }

    private static Optional<RobotView> first(Snapshot snapshot) {
        return snapshot.robots().stream()
                .filter(each -> each.id().equals("robot-1"))
                .findFirst();
    }

    @Test
    @Execution(CONCURRENT)
    void standInsShowWhereRealRobotsAre() throws Exception {
        Process robots = serve(List.of("teleop", "--seed", "5"), 0);
        String servers;
        try (BufferedReader reported = robots.inputReader()) {
            servers = servers(reported, 0, 1);
        }
        var options =
                RunOptions.NONE.withConfiguration("display").withSeed(5).withArguments(Map.of("servers", servers));
        try (LiveRun run = LiveRun.start(Scenario.load("teleop").plan(options))) {
            run.operator().rearm().toCompletableFuture().join();
            Pose2d begin = standIn(run, _ -> true);
            var goal = new Pose2d(begin.x() + (begin.x() < 0 ? 3 : -3), begin.y(), 0); // along the corridor
            run.operator().goTo("robot-1", goal).toCompletableFuture().join();
            standIn(run, mapFromBase -> mapFromBase.distanceTo(goal) < 0.5);
        } finally {
            robots.destroy();
        }
    }

    /// Where that of the first robot is once it is as it should be.
    private static Pose2d standIn(LiveRun run, Predicate<Pose2d> isSo) {
        return standIn(until(run, robot -> standIn(robot).filter(isSo).isPresent()))
                .orElseThrow();
    }

    private static Optional<Pose2d> standIn(RobotView robot) {
        return robot.real().flatMap(RobotView.Real::standIn);
    }

    private static void until(LiveRun run, Predicate<RunEvent> isSo, int times) {
        run.when(_ -> run.events(0).stream().filter(isSo).count() >= times)
                .toCompletableFuture()
                .join();
    }

    /// The first of three ports that nobody has just now.
    private static int threeFree() throws IOException {
        var loopback = InetAddress.getLoopbackAddress();
        while (true) {
            try (var first = new ServerSocket(0, 1, loopback);
                    var _ = new ServerSocket(first.getLocalPort() + 1, 1, loopback);
                    var _ = new ServerSocket(first.getLocalPort() + 2, 1, loopback)) {
                return first.getLocalPort();
            } catch (IOException | IllegalArgumentException e) {
                // one of them is taken; the next first is another
            }
        }
    }
}
