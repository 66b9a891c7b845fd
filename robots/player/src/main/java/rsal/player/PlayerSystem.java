package rsal.player;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import rsal.device.Listeners;
import rsal.device.SimulationControl;
import rsal.device.Subscription;
import rsal.player.ServerAddress.Server;
import rsal.player.client.Delivery;
import rsal.player.device.RemoteRobot;
import rsal.player.device.RemoteServer;
import rsal.player.device.RemoteTruth;
import rsal.robot.Robot;
import rsal.robot.RobotModel;
import rsal.robot.RobotSpec;
import rsal.system.RealRobots.Waiting;
import rsal.system.RobotSystem;
import rsal.time.Scheduler;
import rsal.time.Task;

/// Robots of Player servers. One whose server is lost is gone, and appears again when that is back.
final class PlayerSystem implements RobotSystem {
    private static final Duration RETRY = Duration.ofSeconds(2); // after a robot could not join
    private static final Duration SETUP = Duration.ofSeconds(12); // of a robot's devices, once its servers are there

    private final Map<RobotSpec, ServerAddress> berths;
    private final Optional<Overseer> overseer;
    private final Delivery delivery;
    private final Duration watchdog;
    private final boolean armed;
    private final Waiting waiting;
    private final Scheduler scheduler;
    private final Map<Server, RemoteServer> servers = new LinkedHashMap<>();
    private final List<RemoteRobot> robots = new ArrayList<>();
    private final Listeners<Change> changes = new Listeners<>(e -> {
        throw e;
    });
    private final Task looking; // one for all: each would wake the thread on its own
    private Optional<RemoteTruth> truth = Optional.empty();
    private boolean closed;

    /// Who knows where robots really are.
    ///
    /// @param server the one that simulates them; empty for the first of theirs that does so
    /// @param names what it calls them, by id
    record Overseer(Optional<Server> server, Map<String, String> names) {}

    PlayerSystem(
            Map<RobotSpec, ServerAddress> berths,
            Optional<Overseer> overseer,
            Delivery delivery,
            Duration watchdog,
            boolean armed,
            Waiting waiting,
            Scheduler scheduler) {
        this.berths = berths;
        this.overseer = overseer;
        this.delivery = delivery;
        this.watchdog = watchdog;
        this.armed = armed;
        this.waiting = waiting;
        this.scheduler = scheduler;
        this.looking = scheduler.every(RemoteServer.LOOK, this::look);
    }

    private void look() {
        Instant now = scheduler.instant();
        servers.values().forEach(server -> server.look(now));
    }

    @Override
    public CompletionStage<List<Robot>> discover() {
        if (closed) {
            return CompletableFuture.failedStage(new IllegalStateException("This robot system is closed."));
        }
        berths.values().stream().flatMap(address -> address.servers().stream()).forEach(this::server);
        List<CompletableFuture<Robot>> found = berths.entrySet().stream()
                .map(address -> find(address.getKey(), address.getValue()).toCompletableFuture())
                .toList();
        CompletionStage<Void> seen = overseer.map(this::oversee).orElse(CompletableFuture.completedStage(null));
        return seen.thenCompose(_ -> waiting.late() ? early(found) : complete(found));
    }

    private CompletionStage<List<Robot>> complete(List<CompletableFuture<Robot>> found) {
        return all(found)
                .thenApply(_ -> found.stream()
                        .map(CompletableFuture::join)
                        .map(this::join)
                        .toList());
    }

    /// Its motors are switched as the run wants them.
    private Robot join(Robot robot) {
        robots.stream().filter(each -> each.is(robot)).forEach(RemoteRobot::join);
        return robot;
    }

    /// Those that are found in time. The others appear when they are found. A robot whose servers are there and that
    /// can't
    /// be made ends the discovery.
    private CompletionStage<List<Robot>> early(List<CompletableFuture<Robot>> found) {
        return scheduler.within(waiting.patience(), all(found)).handle((_, _) -> {
            var early = new ArrayList<Robot>();
            List<RobotSpec> specs = List.copyOf(berths.keySet());
            for (int i = 0; i < found.size(); i++) {
                CompletableFuture<Robot> search = found.get(i);
                if (search.isDone()) {
                    early.add(join(search.join()));
                } else {
                    awaitLate(specs.get(i), search, "");
                }
            }
            return List.copyOf(early);
        });
    }

    /// A robot whose servers fail while it joins is tried again, and what is wrong is reported once.
    private void awaitLate(RobotSpec spec, CompletionStage<Robot> search, String reported) {
        var _ = search.handle((robot, error) -> {
            if (closed) {
                return false;
            }
            if (error == null) {
                changes.publish(new Change.Appeared(robot));
                join(robot);
                return true;
            }
            String why = "It can't join: " + RemoteServer.words(error);
            if (!why.equals(reported)) {
                changes.publish(new Change.Gone(spec.id(), why));
            }
            scheduler.after(RETRY, () -> {
                if (!closed) {
                    awaitLate(spec, find(spec, Objects.requireNonNull(berths.get(spec))), why);
                }
            });
            return false;
        });
    }

    @Override
    public Duration discoveryLimit() {
        return waiting.patience().plus(SETUP);
    }

    @Override
    public boolean admitsLateRobots() {
        return waiting.late();
    }

    private RemoteServer server(Server at) {
        return servers.computeIfAbsent(at, _ -> new RemoteServer(at.host(), at.port(), delivery, scheduler));
    }

    private CompletionStage<Void> oversee(Overseer how) {
        List<RemoteServer> all =
                how.server().map(this::server).map(List::of).orElseGet(() -> List.copyOf(servers.values()));
        return all(all.stream().map(server -> server.known(waiting.patience())).toList())
                .thenCompose(_ -> {
                    truth = RemoteTruth.in(all, how.names(), scheduler);
                    return truth.map(RemoteTruth::start)
                            .orElseGet(() -> CompletableFuture.failedStage(new IOException(
                                    "None of the servers %s has a 'simulation'."
                                            .formatted(all.stream()
                                                    .map(server -> "'%s'".formatted(server.name()))
                                                    .toList()))));
                });
    }

    private static CompletionStage<Void> all(List<? extends CompletionStage<?>> stages) {
        return CompletableFuture.allOf(
                stages.stream().map(CompletionStage::toCompletableFuture).toArray(CompletableFuture[]::new));
    }

    private CompletionStage<Robot> find(RobotSpec spec, ServerAddress address) {
        List<RemoteServer> its = address.servers().stream().map(servers::get).toList();
        CompletionStage<Void> known = all(its.stream().map(this::known).toList());
        return known.thenCompose(_ -> {
                    RemoteRobot robot;
                    try {
                        robot = new RemoteRobot(spec, its, before(spec, address), watchdog, armed, scheduler);
                    } catch (IOException e) {
                        return CompletableFuture.failedStage(e);
                    }
                    robots.add(robot);
                    return robot.robot().whenComplete((_, error) -> {
                        if (error != null && robots.remove(robot)) {
                            robot.end();
                        }
                    });
                })
                .thenApply(robot -> {
                    its.forEach(server -> server.onChange(lost -> changed(robot, its, lost)));
                    return robot;
                });
    }

    private CompletionStage<Void> known(RemoteServer server) {
        return waiting.late() ? server.known() : server.known(waiting.patience());
    }

    /// Models of the robots that its servers have before it; those that are not ours are believed to be like
    /// it.
    private List<RobotModel> before(RobotSpec spec, ServerAddress address) {
        return IntStream.range(0, address.index())
                .mapToObj(index -> berths.entrySet().stream()
                        .filter(other -> other.getValue().equals(new ServerAddress(address.servers(), index)))
                        .map(other -> other.getKey().model())
                        .findFirst()
                        .orElse(spec.model()))
                .toList();
    }

    /// It is there as long as all of its servers are.
    private void changed(Robot robot, List<RemoteServer> its, Optional<String> lost) {
        if (lost.isPresent()) {
            changes.publish(new Change.Gone(robot.id(), lost.get()));
        } else if (its.stream().allMatch(RemoteServer::isConnected)) {
            changes.publish(new Change.Appeared(robot));
        }
    }

    @Override
    public Subscription onChange(Consumer<? super Change> listener) {
        return changes.add(listener);
    }

    /// None that is ours: its robots are as real as any.
    @Override
    public Optional<SimulationControl> simulation() {
        return Optional.empty();
    }

    @Override
    public Optional<SimulationControl> truth() {
        return truth.map(SimulationControl.class::cast);
    }

    /// Completes when the servers have got all that was sent, and what they had sent waits for the scheduler's
    /// thread.
    CompletionStage<Void> settled() {
        return all(servers.values().stream().map(RemoteServer::settled).toList());
    }

    @Override
    public void close() {
        closed = true;
        looking.cancel();
        robots.forEach(RemoteRobot::end);
        robots.clear();
        servers.values().forEach(RemoteServer::close);
        servers.clear();
    }
}
