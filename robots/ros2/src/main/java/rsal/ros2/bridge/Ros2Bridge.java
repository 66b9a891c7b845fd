package rsal.ros2.bridge;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.LongSupplier;
import rsal.robot.Robot;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosNetwork;
import rsal.ros2.message.RosMessages;
import rsal.ros2.simulation.PublishedTime;
import rsal.ros2.simulation.SimulationServer;
import rsal.ros2.simulation.TruthTracker;
import rsal.system.Bridge;
import rsal.system.BridgeContext;
import rsal.system.CommandTimeout;
import rsal.system.ExportedDevice;
import rsal.time.Phase;
import rsal.time.Scheduler;
import rsal.time.Task;

/// Publishes all robots for as long as it is open, and the run's time (`/clock`); serves
/// `simulation_interfaces` where the world is simulated.
final class Ros2Bridge implements Bridge {
    /// Name of each robot's node, in its namespace, and of the one without a robot.
    static final String NODE = "rsal";

    private static final Duration TICK = Duration.ofMillis(10);
    private static final Duration LOOK = Duration.ofSeconds(2); // for other programs that publish the same

    private final RosLink link;
    private final BridgeContext context;
    private final int port;
    private final PublishedTime time;
    private final RosMessages messages = new RosMessages();
    private final Map<String, Joined> robots = new LinkedHashMap<>(); // by id
    private final ClockFollowers clock;
    private final CommandTimeout timeout; // by a clock of all robots
    private final CommandClock commandClock;
    private final Task ticking;
    private final Task looking;
    private final OtherPublishers rivals = new OtherPublishers();
    private final Executor requests; // are answered there
    private final PublishedHealth health;
    private final Optional<TruthTracker> truth;
    private final Optional<SimulationServer> simulation;
    private boolean closed;

    /// A robot with its node.
    ///
    /// @param truth where it really is, if it is simulated
    private record Joined(
            Robot robot, RosLink node, PublishedRobot published, PublishedModel model, Optional<PublishedTruth> truth) {
        void close() {
            published.close();
            model.close();
            truth.ifPresent(PublishedTruth::close);
            node.close();
        }
    }

    /// The time by which commands get old: that on the wall, or the run's own while programs that follow it hold
    /// it back. Such a run is as slow as they are, so real time would make their commands old before they could
    /// send others. Only goes forward. Of the run's thread.
    private static final class CommandClock {
        private final LongSupplier real; // [ns]
        private final InstantSource run;
        private boolean isOfRun;
        private long before; // what had passed when it changed over [ns]
        private long since; // what the one that counts said then [ns]

        /// @param real time [ns]
        CommandClock(LongSupplier real, InstantSource run) {
            this.real = real;
            this.run = run;
            since = real.getAsLong();
            before = since;
        }

        private long source() {
            return isOfRun ? Duration.between(Instant.EPOCH, run.instant()).toNanos() : real.getAsLong();
        }

        /// [ns]
        long now() {
            return before + source() - since;
        }

        /// Whether the run is held back from now on.
        void follow(Pace pace) {
            boolean isHeld = pace == Pace.FOLLOWED || pace == Pace.AWAITED;
            if (isHeld != isOfRun) {
                before = now();
                isOfRun = isHeld;
                since = source();
            }
        }
    }

    /// @param link of the node `/rsal`, which this closes
    /// @param port for people: where the domain's participants hear of each other
    Ros2Bridge(RosLink link, BridgeContext context, int port, Scheduler scheduler) {
        this.link = link;
        this.context = context;
        this.port = port;
        time = new PublishedTime(scheduler);
        commandClock = new CommandClock(context.timeout().nanos(), scheduler);
        timeout = new CommandTimeout(context.timeout().limit(), commandClock::now);
        clock = new ClockFollowers(
                link,
                context.isPaced(),
                context.timeout().nanos(),
                () -> context.control().ifPresent(control -> control.execute(() -> {})));
        ticking = scheduler.every(TICK, Phase.OBSERVE, this::tick);
        looking = scheduler.every(LOOK, Phase.OBSERVE, this::lookForRivals);
        requests = context.control().<Executor>map(control -> control).orElse(scheduler);
        new NodeParameters("/" + NODE, NodeParameters.of(context)).serve(link, requests, time);
        health = new PublishedHealth(this::robots, link, time);
        truth = context.simulation().map(world -> new TruthTracker(world, scheduler));
        simulation = truth.flatMap(tracked -> context.control()
                .map(control -> new SimulationServer(
                        "/" + NODE,
                        context.simulation().orElseThrow(),
                        control,
                        tracked,
                        this::robot,
                        this::restart,
                        this::halt,
                        link,
                        time)));
        link.together(() -> context.robots().forEach(this::join));
    }

    private Optional<Robot> robot(String id) {
        return Optional.ofNullable(robots.get(id)).map(Joined::robot);
    }

    private Collection<Robot> robots() {
        return robots.values().stream().map(Joined::robot).toList();
    }

    private void lookForRivals() {
        List<String> own = robots.keySet().stream()
                .map(robot -> RosNetwork.namespace(robot) + "/odom")
                .toList();
        rivals.look(own, link.endpoints());
    }

    private void tick() {
        Instant now = time.instant();
        clock.publish(Duration.between(Instant.EPOCH, now).toNanos(), messages.clock(now));
    }

    /// A program resets the time.
    private void restart() {
        time.restart();
        clock.restart();
        tick();
    }

    /// A program stops the simulation.
    private void halt() {
        robots.values().forEach(robot -> robot.published.halt());
    }

    /// So that sensors and commands are late by no more than the time between two messages of `/clock`.
    @Override
    public Optional<Duration> grain() {
        return Optional.of(TICK);
    }

    @Override
    public Pace pace() {
        Pace pace = clock.pace();
        commandClock.follow(pace);
        return pace;
    }

    @Override
    public List<ExportedDevice> offers() {
        return robots.values().stream()
                .flatMap(robot -> robot.published.offers().stream())
                .toList();
    }

    @Override
    public List<ExportedDevice> join(Robot robot) {
        return robots.computeIfAbsent(robot.id(), _ -> publish(robot)).published.offers();
    }

    private Joined publish(Robot robot) {
        String namespace = RosNetwork.namespace(robot.id());
        RosLink node = link.node(namespace, NODE);
        List<NodeParameters.Parameter> parameters = NodeParameters.of(robot, context);
        new NodeParameters(namespace + "/" + NODE, parameters).serve(node, requests, time);
        return new Joined(
                robot,
                node,
                new PublishedRobot(robot, context.map(), timeout, parameters, node, port, requests, time),
                new PublishedModel(robot, node, namespace, time),
                truth.filter(tracked -> tracked.pose(robot.id()).isPresent())
                        .map(tracked -> new PublishedTruth(robot.id(), tracked, node, namespace, time)));
    }

    @Override
    public void leave(String robot) {
        Joined gone = robots.remove(robot);
        if (gone != null) {
            gone.close();
        }
    }

    @Override
    public void close() {
        if (!closed) {
            closed = true;
            ticking.cancel();
            looking.cancel();
            clock.close();
            health.close();
            simulation.ifPresent(SimulationServer::close);
            truth.ifPresent(TruthTracker::close);
            robots.values().forEach(Joined::close);
            robots.clear();
            link.close();
        }
    }
}
