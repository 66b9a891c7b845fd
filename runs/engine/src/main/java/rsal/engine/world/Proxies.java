package rsal.engine.world;

import java.time.Duration;
import java.time.Instant;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.data.Stamped;
import rsal.device.Gripper;
import rsal.device.SimulationControl;
import rsal.device.SimulationControl.Marker;
import rsal.device.SimulationControl.Placement;
import rsal.device.SimulationControl.Thing;
import rsal.engine.event.EventLog;
import rsal.engine.robot.RobotPoses;
import rsal.engine.robot.RobotSystems;
import rsal.engine.robot.RobotTeam;
import rsal.robot.RobotSpec;
import rsal.scenario.RunPlan.PlannedRobot;
import rsal.scene.Surface;
import rsal.time.Phase;
import rsal.time.Scheduler;

/// Stand-ins of real robots in the simulated world: bodies without devices under the robots' own ids, which
/// simulated robots see and run into. Each stands where its robot's localizer says, or, when it has none, where
/// its odometry has taken it from its start. It stands there whether there is room or not, for the robot does,
/// and takes along what its robot has [gripped][ProxyGrasp]. All calls on the run's thread.
///
/// Nothing is guessed in between or ahead: what was measured is late by a little at most, while a guess is
/// wrong by as much as the robot brakes, turns or its localizer jumps, and nobody could tell it from what was
/// measured.
public final class Proxies {
    private static final Duration BEAT = Duration.ofMillis(100);
    private static final Duration PATIENCE = Duration.ofSeconds(1);
    private static final double JUMP = 1; // of one update, from which on it is told [m]

    private final RobotSystems systems;
    private final RobotTeam team;
    private final RobotPoses where;
    private final Scheduler scheduler;
    private final EventLog eventLog;
    private final Map<String, Proxy> proxies = new LinkedHashMap<>();
    private boolean beating;

    public Proxies(RobotSystems systems, RobotTeam team, RobotPoses where, Scheduler scheduler, EventLog eventLog) {
        this.systems = systems;
        this.team = team;
        this.where = where;
        this.scheduler = scheduler;
        this.eventLog = eventLog;
    }

    /// A robot of the team is there.
    public void join(PlannedRobot planned) {
        if (planned.proxy()) {
            proxies.putIfAbsent(planned.spec().id(), new Proxy(planned.spec()));
        }
        if (!beating && !proxies.isEmpty()) {
            beating = true;
            // After devices have told where robots are, and before the world looks at them next.
            scheduler.every(BEAT, Phase.OBSERVE, () -> systems.simulation().ifPresent(this::beat));
        }
    }

    /// A robot has left for good.
    public void leave(String robot) {
        Optional.ofNullable(proxies.remove(robot))
                .ifPresent(proxy -> systems.simulation().ifPresent(proxy::hide));
    }

    /// Whether a robot is to have one.
    boolean has(String robot) {
        return proxies.containsKey(robot);
    }

    /// Names of all in the simulated world that stands for what is real: the stand-ins, and what they take along.
    public Set<String> names() {
        var names = new HashSet<>(proxies.keySet());
        proxies.values().forEach(proxy -> proxy.grasp.thing().ifPresent(names::add));
        return names;
    }

    /// Where it is, in the map frame; empty when there is none now.
    Optional<Pose2d> mapFromProxy(String robot) {
        return has(robot) ? systems.simulation().flatMap(world -> world.truth(robot)) : Optional.empty();
    }

    private void beat(SimulationControl world) {
        proxies.values().forEach(proxy -> proxy.beat(world));
    }

    /// One stand-in.
    private final class Proxy {
        private final RobotSpec spec;
        private final ProxyGrasp grasp;
        private @Nullable Stamped<Pose2d> shown;
        private Instant heard = Instant.MIN;
        private String refused = "";
        private boolean stale;

        Proxy(RobotSpec spec) {
            this.spec = spec;
            this.grasp = new ProxyGrasp(spec, thing -> names().contains(thing), this::publish);
        }

        void beat(SimulationControl world) {
            Optional<Stamped<Pose2d>> known = where.known(spec);
            if (known.isEmpty()) {
                hide(world);
            } else if (!known.get().equals(shown)) {
                heard = scheduler.instant();
                stale(false);
                show(world, known.get());
            } else if (heard.plus(PATIENCE).isBefore(scheduler.instant())) {
                stale(true);
            }
            Optional.ofNullable(shown)
                    .ifPresent(pose -> team.robot(spec.id())
                            .flatMap(robot -> robot.find(Gripper.class))
                            .ifPresent(gripper -> grasp.follow(world, gripper, pose.value())));
        }

        private void show(SimulationControl world, Stamped<Pose2d> now) {
            Placement placement = world.truth(spec.id()).isPresent()
                    ? world.placeAnyway(spec.id(), now.value())
                    : world.addAnyway(body(now.value()));
            String why = placement instanceof Placement.Refused(String words) ? words : "";
            if (!why.isEmpty() && refused.isEmpty()) {
                publish("can't stand in the simulated world: " + why);
            }
            refused = why;
            if (shown != null && shown.value().distanceTo(now.value()) > JUMP) {
                publish(String.format(
                        Locale.ROOT, "jumped by %.1f m", shown.value().distanceTo(now.value())));
            }
            shown = now;
            if (!why.isEmpty()) {
                world.remove(spec.id());
            }
        }

        private Thing body(Pose2d mapFromBase) {
            return new Thing(
                    spec.id(),
                    mapFromBase,
                    spec.model().body(),
                    Rgb.parse(spec.color()).orElse(Surface.PLAIN.color()),
                    true,
                    false,
                    spec.marker().isPresent()
                            ? Optional.of(new Marker(spec.marker().getAsInt(), 0))
                            : Optional.empty(),
                    0);
        }

        void hide(SimulationControl world) {
            grasp.letGo(world);
            world.remove(spec.id());
            shown = null;
        }

        private void stale(boolean now) {
            if (now != stale) {
                stale = now;
                publish(
                        now
                                ? "is stale: for more than %d s nobody has told where it is"
                                        .formatted(PATIENCE.toSeconds())
                                : "is where it is told to be again");
            }
        }

        private void publish(String words) {
            eventLog.event("proxy", spec.id(), words);
        }
    }
}
