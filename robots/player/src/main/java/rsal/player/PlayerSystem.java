package rsal.player;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import rsal.device.Listeners;
import rsal.device.SimulationControl;
import rsal.device.Subscription;
import rsal.player.Berth.Server;
import rsal.player.device.RemoteRobot;
import rsal.player.device.RemoteServer;
import rsal.robot.Robot;
import rsal.robot.RobotSpec;
import rsal.system.RobotSystem;
import rsal.time.Scheduler;

/// Robots of Player servers. One whose server is lost is gone, and appears again when that is back.
final class PlayerSystem implements RobotSystem {
    private static final Duration PATIENCE = Duration.ofSeconds(8);

    private final Map<RobotSpec, Berth> berths;
    private final Duration watchdog;
    private final boolean armed;
    private final Scheduler scheduler;
    private final Map<Server, RemoteServer> servers = new LinkedHashMap<>();
    private final List<RemoteRobot> robots = new ArrayList<>();
    private final Listeners<Change> changes = new Listeners<>(e -> {
        throw e;
    });
    private boolean closed;

    PlayerSystem(Map<RobotSpec, Berth> berths, Duration watchdog, boolean armed, Scheduler scheduler) {
        this.berths = berths;
        this.watchdog = watchdog;
        this.armed = armed;
        this.scheduler = scheduler;
    }

    @Override
    public CompletionStage<List<Robot>> discover() {
        if (closed) {
            return CompletableFuture.failedStage(new IllegalStateException("This robot system is closed."));
        }
        berths.forEach((spec, berth) -> berth.servers()
                .forEach(server -> servers.computeIfAbsent(
                        server, _ -> new RemoteServer(server.host(), server.port(), scheduler))));
        List<CompletableFuture<Robot>> found = berths.entrySet().stream()
                .map(berth -> find(berth.getKey(), berth.getValue()).toCompletableFuture())
                .toList();
        CompletionStage<Void> all = all(found);
        return all.thenApply(_ -> found.stream().map(CompletableFuture::join).toList());
    }

    private static CompletionStage<Void> all(List<? extends CompletionStage<?>> stages) {
        return CompletableFuture.allOf(
                stages.stream().map(CompletionStage::toCompletableFuture).toArray(CompletableFuture[]::new));
    }

    private CompletionStage<Robot> find(RobotSpec spec, Berth berth) {
        List<RemoteServer> its = berth.servers().stream().map(servers::get).toList();
        CompletionStage<Void> known =
                all(its.stream().map(server -> server.known(PATIENCE)).toList());
        return known.thenCompose(_ -> {
                    var robot = new RemoteRobot(spec, its, berth.index(), watchdog, armed, scheduler);
                    robots.add(robot);
                    return robot.robot();
                })
                .thenApply(robot -> {
                    its.forEach(server -> server.onChange(lost -> changed(robot, its, lost)));
                    return robot;
                });
    }

    /// It is there as long as all of its servers are.
    private void changed(Robot robot, List<RemoteServer> its, Optional<String> lost) {
        if (lost.isPresent()) {
            changes.tell(new Change.Gone(robot.id(), lost.get()));
        } else if (its.stream().allMatch(RemoteServer::isConnected)) {
            changes.tell(new Change.Appeared(robot));
        }
    }

    @Override
    public Subscription onChange(Consumer<? super Change> listener) {
        return changes.add(listener);
    }

    @Override
    public Optional<SimulationControl> simulation() {
        return Optional.empty();
    }

    /// Completes when the servers have got all that was sent, and what they had sent waits for the scheduler's thread.
    CompletionStage<Void> settled() {
        return all(servers.values().stream().map(RemoteServer::settled).toList());
    }

    @Override
    public void close() {
        closed = true;
        robots.forEach(RemoteRobot::end);
        robots.clear();
        servers.values().forEach(RemoteServer::close);
        servers.clear();
    }
}
