package rsal.ros2.system;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
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
import java.util.random.RandomGenerator;
import org.jspecify.annotations.Nullable;
import rsal.device.Listeners;
import rsal.device.SimulationControl;
import rsal.device.Subscription;
import rsal.robot.Robot;
import rsal.robot.RobotSpec;
import rsal.ros2.device.RobotTopics;
import rsal.ros2.device.RosRobot;
import rsal.ros2.health.RobotDiagnostics;
import rsal.ros2.link.RosEndpoint;
import rsal.ros2.link.RosLink;
import rsal.ros2.setting.RosSettings;
import rsal.ros2.transform.TransformTopics;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;
import rsal.system.RealRobots.Waiting;
import rsal.system.RobotSystem;
import rsal.time.Scheduler;
import rsal.time.Task;

/// Robots of ROS 2. One whose odometry nobody publishes any more is gone, and appears again when somebody does.
final class Ros2System implements RobotSystem {
    private static final Logger LOG = System.getLogger(Ros2System.class.getName());
    private static final Distribution USUAL = Distribution.JAZZY; // where several fit
    private static final Duration QUIET = Duration.ofSeconds(3); // of waiting, before people learn for whom
    private static final Duration SETTLING = Duration.ofSeconds(2); // of topics, after the first of a robot

    private final Map<RobotSpec, String> namespaces;
    private final String networkName;
    private final Opening opening;
    private final Optional<Distribution> distribution;
    private final RosSettings settings;
    private final Waiting waiting;
    private final Scheduler scheduler;
    private final RandomGenerator random;
    private final Map<RobotSpec, RosRobot> found = new LinkedHashMap<>();
    private final Map<RobotSpec, Instant> seen = new LinkedHashMap<>();
    private final Map<RobotSpec, RobotTopics> topics = new LinkedHashMap<>(); // of those that are not found
    private final Map<RosRobot, Boolean> present = new LinkedHashMap<>(); // those that the run has
    private final CompletableFuture<List<Robot>> discovered = new CompletableFuture<>();
    private final Listeners<Change> changes = new Listeners<>(e -> {
        throw e;
    });
    private final List<Task> looking = new ArrayList<>();
    private Consumer<? super Instant> timeListener = _ -> {};
    private Optional<SimulatorClock> clock = Optional.empty(); // that the run follows
    private @Nullable RosLink link;
    private Optional<RobotDiagnostics> diagnostics = Optional.empty(); // once the network is joined
    private @Nullable TransformTopics transforms; // of the link
    private List<RosEndpoint> endpoints = List.of(); // of the network, when it was last looked at
    private Instant progressAt = Instant.MIN; // when it was last made
    private int progress; // of finding them
    private boolean hasReported; // since the last progress
    private boolean closed;

    /// Joins the network.
    interface Opening {
        RosLink open() throws IOException;
    }

    /// @param namespaces of the robots: `/robot1`, or `/` for topics without one
    /// @param networkName for people: `domain 5`
    /// @param distribution of all robots; empty for what each of them announces
    Ros2System(
            Map<RobotSpec, String> namespaces,
            String networkName,
            Opening opening,
            Optional<Distribution> distribution,
            RosSettings settings,
            Waiting waiting,
            Scheduler scheduler,
            RandomGenerator random) {
        this.namespaces = namespaces;
        this.networkName = networkName;
        this.opening = opening;
        this.distribution = distribution;
        this.settings = settings;
        this.waiting = waiting;
        this.scheduler = scheduler;
        this.random = random;
    }

    @Override
    public void onTime(Consumer<? super Instant> listener) {
        timeListener = listener;
    }

    /// A simulator that waits is not to wait for robots to be found. It hears of velocities first, also of those that
    /// were wanted before time stood.
    @Override
    public void reached(Instant time) {
        if (discovered.isDone() && !closed) {
            Instant now = scheduler.instant();
            found.values().forEach(robot -> robot.release(now));
            clock.ifPresent(simulator -> simulator.reached(time));
        }
    }

    /// Robots are found and motors kept safe in real time, so also while that of the run stands.
    @Override
    public CompletionStage<List<Robot>> discover() {
        if (closed) {
            return CompletableFuture.failedStage(new IllegalStateException("This robot system is closed."));
        }
        try {
            link = opening.open();
            transforms = new TransformTopics(link, scheduler);
            if (settings.useSimTime()) {
                clock = Optional.of(new SimulatorClock(link, networkName, timeListener));
            }
        } catch (IOException e) {
            return CompletableFuture.failedStage(
                    new IOException("The network of ROS 2 can't be joined: %s".formatted(e.getMessage()), e));
        }
        if (settings.hasDiagnostics()) {
            diagnostics = Optional.of(new RobotDiagnostics(link, scheduler));
        }
        Scheduler real = scheduler.inRealTime();
        progressAt = real.instant();
        looking.add(real.every(RosRobot.LOOK, () -> search(real.instant())));
        looking.add(scheduler.every(RosRobot.LOOK, this::look));
        return discovered;
    }

    /// A robot makes progress twice: when it is found, and when it is ready; the clock does so once.
    @Override
    public Duration discoveryLimit() {
        return waiting.patience().multipliedBy(2 + 2L * namespaces.size()).plusSeconds(1);
    }

    @Override
    public boolean admitsLateRobots() {
        return waiting.late();
    }

    private void look() {
        if (!closed) {
            Instant now = scheduler.instant();
            found.values().forEach(robot -> robot.look(now));
        }
    }

    /// @param now in real time
    private void search(Instant now) {
        if (closed || link == null) {
            return;
        }
        clock.ifPresent(time -> follow(time, now));
        if (found.size() < namespaces.size()) {
            search(link, now);
        }
        if (!discovered.isDone()) {
            await(now);
        }
        if (discovered.isDone()) {
            found.values().forEach(robot -> compare(robot, robot.isThere()));
        }
    }

    /// Stops robots that are commanded no more, as time stands. A simulator that says the same time again and again
    /// waits for a program: it stands itself, and a stop would only depend on how long that program takes.
    ///
    /// @throws IllegalStateException when the simulator has gone
    private void follow(SimulatorClock time, Instant now) {
        time.look(now);
        if (time.hasBegun() && time.silence(now).compareTo(settings.safety().watchdog()) > 0) {
            found.values().forEach(robot -> robot.hold(now));
        }
        if (time.hasBegun() && time.unpublished(now).compareTo(waiting.patience()) > 0) {
            throw new IllegalStateException("The run can't go on without time. " + time.missing());
        }
    }

    /// Whether the run has a time.
    private boolean isTimed() {
        return clock.map(SimulatorClock::hasBegun).orElse(true);
    }

    /// Reports what has changed since the last look. A robot that has joined late is ready when it appears.
    private void compare(RosRobot robot, boolean isThere) {
        boolean wasThere = present.getOrDefault(robot, false);
        if (isThere != wasThere && (present.containsKey(robot) || robot.isReady())) {
            boolean wasKnown = present.put(robot, isThere) != null;
            Robot its = robot.robot();
            if (isThere && wasKnown) {
                robot.appear();
            }
            changes.publish(
                    isThere
                            ? new Change.Appeared(its)
                            : new Change.Gone(its.id(), "Nobody publishes its odometry any more."));
            if (isThere) { // also again: it may have missed that its motors were switched
                robot.join();
            }
        }
    }

    private void search(RosLink network, Instant now) {
        List<RosEndpoint> all = network.endpoints();
        if (!all.equals(endpoints)) {
            endpoints = all;
            topics.clear();
        }
        network.together(() -> namespaces.forEach((spec, namespace) -> {
            if (!found.containsKey(spec)) {
                RobotTopics its = topics.computeIfAbsent(spec, _ -> topics(namespace, all));
                if (RosRobot.lacking(its).isEmpty()) {
                    meet(spec, its, network, now);
                }
            }
        }));
    }

    /// Ends the discovery when all robots are ready, or nothing more has come for too long.
    private void await(Instant now) {
        List<RosRobot> ready = namespaces.keySet().stream()
                .map(found::get)
                .filter(Objects::nonNull)
                .filter(RosRobot::isReady)
                .toList();
        int made = ready.size() + found.size() + (isTimed() ? 1 : 0);
        if (made > progress) {
            progress = made;
            progressAt = now;
            hasReported = false;
        }
        if (!hasReported && now.isAfter(progressAt.plus(QUIET))) {
            hasReported = true;
            LOG.log(Level.WARNING, () -> "Still waiting for robots. " + missing(endpoints));
        }
        boolean isTooLate = now.isAfter(progressAt.plus(waiting.patience()));
        if (isTimed() && (ready.size() == namespaces.size() || (isTooLate && waiting.late()))) {
            ready.forEach(robot -> {
                present.put(robot, true);
                robot.join();
            });
            // so that a simulator that waits does so from now on, as a run takes a while to begin
            clock.ifPresent(simulator -> simulator.reached(scheduler.instant()));
            discovered.complete(ready.stream().map(RosRobot::robot).toList());
        } else if (isTooLate) {
            discovered.completeExceptionally(new IOException(missing(endpoints)));
        }
    }

    /// Takes a robot when all of its topics are there, or have had their time to appear.
    private void meet(RobotSpec spec, RobotTopics its, RosLink network, Instant now) {
        Instant first = seen.computeIfAbsent(spec, _ -> now);
        if (!RosRobot.isComplete(spec, its, settings) && !now.isAfter(first.plus(SETTLING))) {
            return;
        }
        RosRobot robot = robot(spec, its, network);
        found.put(spec, robot);
        topics.remove(spec);
        List<String> without = robot.without();
        if (!without.isEmpty()) {
            LOG.log(
                    Level.INFO,
                    () -> "Robot '%s' publishes nothing for %s.".formatted(spec.id(), String.join(", ", without)));
        }
    }

    private RosRobot robot(RobotSpec spec, RobotTopics topics, RosLink network) {
        Distribution its = distribution.or(network::distribution).orElseGet(() -> topics.distribution(USUAL));
        LOG.log(Level.INFO, () -> "Robot '%s' has messages of %s.".formatted(spec.id(), its.words()));
        return new RosRobot(
                spec,
                topics,
                network,
                Objects.requireNonNull(transforms),
                TypeLibrary.of(its),
                settings,
                diagnostics,
                scheduler,
                random);
    }

    private static RobotTopics topics(String namespace, List<RosEndpoint> all) {
        return new RobotTopics(namespace.equals("/") ? "" : namespace, all);
    }

    /// For people: that there is no time, or what the first robot that was not found lacks.
    private String missing(List<RosEndpoint> all) {
        Optional<String> trouble = link == null ? Optional.empty() : link.trouble();
        if (trouble.isPresent()) {
            return trouble.get();
        }
        if (!isTimed() && !all.isEmpty()) {
            return clock.orElseThrow().missing();
        }
        for (Map.Entry<RobotSpec, String> each : namespaces.entrySet()) {
            RobotTopics topics = topics(each.getValue(), all);
            List<String> lacking = RosRobot.lacking(topics);
            if (!lacking.isEmpty()) {
                return "Robot '%s' was not found in the namespace '%s': it lacks %s. %s %s"
                        .formatted(
                                each.getKey().id(),
                                each.getValue(),
                                String.join(", ", lacking),
                                topics.words(),
                                all.isEmpty() ? nothing() : "");
            }
        }
        return "A robot publishes no odometry, though it has a topic for it.";
    }

    private String nothing() {
        return "Nothing of ROS 2 was found at all; "
                + Objects.requireNonNull(link).suspicion();
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
    public void close() {
        if (closed) {
            return;
        }
        closed = true;
        looking.forEach(Task::cancel);
        found.values().forEach(RosRobot::end);
        found.clear();
        diagnostics.ifPresent(RobotDiagnostics::close);
        if (link != null) {
            link.close();
        }
    }
}
