package rsal.player.device;

import java.time.Duration;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import rsal.data.Pose2d;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.Health;
import rsal.device.SimulationControl;
import rsal.player.message.Chars;
import rsal.player.message.Interface;
import rsal.player.message.Pose;
import rsal.player.message.Simulation;
import rsal.player.wire.Address;
import rsal.time.Scheduler;

/// Where robots really are, behind a server's `simulation`. It is asked about each as long as somebody looks, ten
/// times a second, so that the first look shows nothing and the others what is late by a tenth of a second and the
/// way there and back. All on the scheduler's thread.
///
/// Who places a robot does not wait for the server: placed means that it was asked to. When it refuses, that is
/// logged, and the robot is seen where it was. Nobody is told of collisions.
public final class RemoteTruth extends DeviceCore implements SimulationControl, Remote {
    private static final System.Logger LOG = System.getLogger(RemoteTruth.class.getName());
    private static final Duration PERIOD = Duration.ofMillis(100);
    private static final Duration FRESH = Duration.ofSeconds(1); // an answer; and for so long a look counts

    private final RemoteServer server;
    private final Address address;
    private final Scheduler scheduler;
    private final Map<String, Seen> robots = new LinkedHashMap<>(); // by id

    /// What is known of a robot.
    private static final class Seen {
        private final String name; // in the server's world
        private Optional<Pose2d> mapFromRobot = Optional.empty();
        private Instant reportedAt = Instant.MIN;
        private Instant lookedAt = Instant.MIN;
        private Instant askedAt = Instant.MIN;
        private Object question = new Object(); // whose answer counts
        private boolean asking;
        private boolean isRefused; // which was said

        Seen(String name) {
            this.name = name;
        }

        /// What is known or on its way is of before.
        void forget() {
            mapFromRobot = Optional.empty();
            question = new Object();
            asking = false;
            askedAt = Instant.MIN;
        }
    }

    private RemoteTruth(RemoteServer server, Address address, Map<String, String> names, Scheduler scheduler) {
        super(new DeviceInfo("", "simulation", "player"));
        this.server = server;
        this.address = address;
        this.scheduler = scheduler;
        names.forEach((id, name) -> robots.put(id, new Seen(name)));
    }

    /// That of the first server that has one; empty when none has.
    ///
    /// @param servers that are [known][RemoteServer#known]
    /// @param names in the server's world, by robot
    public static Optional<RemoteTruth> in(List<RemoteServer> servers, Map<String, String> names, Scheduler scheduler) {
        return servers.stream()
                .flatMap(server -> server.offer().of(Interface.SIMULATION).stream()
                        .map(address -> new RemoteTruth(server, address, names, scheduler)))
                .findFirst();
    }

    /// Completes when the server works with it.
    public CompletionStage<Void> start() {
        return server.add(this);
    }

    @Override
    public Address address() {
        return address;
    }

    @Override
    public List<String> entities() {
        return List.copyOf(robots.keySet());
    }

    @Override
    public Optional<Pose2d> truth(String entity) {
        return Optional.ofNullable(robots.get(entity)).flatMap(seen -> {
            Instant now = scheduler.instant();
            seen.lookedAt = now;
            return seen.reportedAt.plus(FRESH).isBefore(now) ? Optional.empty() : seen.mapFromRobot;
        });
    }

    @Override
    public void look(Instant now) {
        for (Seen seen : robots.values()) {
            boolean wanted = !seen.lookedAt.isBefore(now.minus(FRESH));
            boolean due = !seen.askedAt.isAfter(now.minus(PERIOD));
            if (wanted && due && !seen.asking && server.isConnected()) {
                ask(seen, now);
            }
        }
    }

    private void ask(Seen seen, Instant now) {
        var own = new Object();
        seen.question = own;
        seen.asking = true;
        seen.askedAt = now;
        server.ask(address, Simulation.POSE, Optional.of(placed(seen, Pose2d.ORIGIN)))
                .whenComplete((answer, error) -> {
                    if (!own.equals(seen.question)) {
                        return;
                    }
                    seen.asking = false;
                    seen.reportedAt = scheduler.instant();
                    seen.mapFromRobot = error == null ? pose(seen, answer) : Optional.empty();
                    warnIfRefused(seen, Optional.ofNullable(error));
                });
    }

    /// Says once that the server does not tell where a robot is, as one does whose world has none of that name.
    private void warnIfRefused(Seen seen, Optional<Throwable> error) {
        if (error.isPresent() && server.isConnected() && !seen.isRefused) {
            seen.isRefused = true;
            LOG.log(
                    System.Logger.Level.WARNING,
                    () ->
                            "The simulation at '%s' does not report the pose of '%s': %s Maybe it has another name there ('names')."
                                    .formatted(server.name(), seen.name, RemoteServer.words(error.get())));
        }
    }

    private static Simulation.Placed placed(Seen seen, Pose2d mapFromRobot) {
        return new Simulation.Placed(Chars.of(seen.name), Pose.of(mapFromRobot));
    }

    private static Optional<Pose2d> pose(Seen seen, Optional<Record> answer) {
        return answer.filter(Simulation.Placed.class::isInstance)
                .map(Simulation.Placed.class::cast)
                .filter(reported -> Chars.text(reported.name()).equals(seen.name))
                .map(reported -> reported.pose().to2d())
                .filter(Pose2d::isFinite);
    }

    @Override
    public Placement place(String entity, Pose2d mapFromEntity) {
        Seen seen = robots.get(entity);
        if (seen == null) {
            return new Placement.Refused("There is no robot '%s'.".formatted(entity));
        }
        if (!mapFromEntity.isFinite()) {
            return new Placement.Refused("A place must be finite, not '%s'.".formatted(mapFromEntity));
        }
        if (!server.isConnected()) {
            return new Placement.Refused(
                    "The simulation at '%s' is lost: %s".formatted(server.name(), server.reason()));
        }
        seen.forget();
        server.ask(address, Simulation.SET_POSE, Optional.of(placed(seen, mapFromEntity)))
                .whenComplete((_, error) -> {
                    if (error != null) {
                        LOG.log(
                                System.Logger.Level.WARNING,
                                () -> "'%s' was not placed: %s".formatted(entity, RemoteServer.words(error)));
                    }
                });
        return new Placement.Placed();
    }

    /// None: Player does not tell of any.
    @Override
    public List<Contact> contacts() {
        return List.of();
    }

    @Override
    public void connected() {
        health(Health.ok());
    }

    /// Nobody tells unasked.
    @Override
    public void take(Instant time, Record body) {}

    @Override
    public void lost(String reason) {
        robots.values().forEach(Seen::forget);
        health(new Health.Lost(reason));
    }
}
