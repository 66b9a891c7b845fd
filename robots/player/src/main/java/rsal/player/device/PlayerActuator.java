package rsal.player.device;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;
import rsal.data.ActuatorState;
import rsal.data.ActuatorState.Motion;
import rsal.data.Interval;
import rsal.device.Actuator;
import rsal.device.DeviceInfo;
import rsal.device.GoalHandle;
import rsal.device.GoalSource;
import rsal.player.message.Actarray;
import rsal.player.wire.Address;
import rsal.robot.RobotModel.Part;

/// A joint behind `actarray`, the first one of it. As with a base, a speed holds there until the next command,
/// so that this one sees to it that commands dry up. While its robot's motors are off it stands still; then it
/// goes on to where it was to go.
final class PlayerActuator extends PlayerSensor<ActuatorState> implements Actuator {
    private static final Duration PATIENCE = Duration.ofSeconds(60);
    private static final double NEAR = 0.005; // of its whole way

    private final RemoteServer server;
    private final PlayerBase base;
    private final InstantSource clock;
    private final Duration watchdog;
    private final Part.Actuator part;
    private Interval limits;
    private double position;
    private @Nullable GoalSource<ActuatorState, Result> goal;
    private double target;
    private Instant begun = Instant.MIN;
    private OptionalDouble speed = OptionalDouble.empty(); // that is wanted
    private Instant wantedAt = Instant.MIN;

    PlayerActuator(
            DeviceInfo info,
            Address address,
            RemoteServer server,
            PlayerBase base,
            Part.Actuator part,
            Duration watchdog,
            InstantSource clock) {
        super(info, address, info.id());
        this.server = server;
        this.base = base;
        this.part = part;
        this.watchdog = watchdog;
        this.clock = clock;
        this.limits = part.limits();
        this.position = part.home();
        base.onMotors(this::motors);
    }

    private void motors(boolean enabled) {
        if (!enabled) {
            speed = OptionalDouble.empty();
            send(0);
        } else if (goal != null) {
            begun = clock.instant();
            sendThere();
        }
    }

    private void sendThere() {
        server.command(address(), Actarray.POSITION, new Actarray.Position(0, (float) target));
    }

    @Override
    public List<Integer> questions() {
        return List.of(Actarray.GEOMETRY);
    }

    @Override
    public void answered(Record body) {
        limits = Joints.limits(body).orElse(limits);
    }

    @Override
    Optional<ActuatorState> read(Record body) {
        return Joints.first(body).map(this::state);
    }

    private ActuatorState state(Actarray.Joint joint) {
        position = joint.position();
        Motion motion = switch (joint.state()) {
            case Actarray.MOVING -> Motion.MOVING;
            case Actarray.STALLED -> Motion.STALLED;
            default -> Motion.IDLE;
        };
        return new ActuatorState(part.joint(), position, joint.speed(), limits, motion);
    }

    @Override
    public void take(Instant time, Record body) {
        super.take(time, body);
        if (goal != null) {
            latest().ifPresent(goal::publish);
            if (Math.abs(position - target) <= NEAR * (limits.most() - limits.least())) {
                end(new Result.Reached(position));
            }
        }
    }

    @Override
    public GoalHandle<ActuatorState, Result> goTo(double wanted) {
        if (!Double.isFinite(wanted)) {
            throw new IllegalArgumentException("A position must be finite, not '%s'.".formatted(wanted));
        }
        GoalHandle<ActuatorState, Result> handle = begin(limits.clamp(wanted));
        if (base.enabled()) {
            sendThere();
        }
        return handle;
    }

    /// To the place that its model has for it: Player's own HOME, which says not where that is, goes elsewhere
    /// with some drivers.
    @Override
    public GoalHandle<ActuatorState, Result> home() {
        return goTo(part.home());
    }

    private GoalHandle<ActuatorState, Result> begin(double place) {
        end(new Result.Cancelled());
        speed = OptionalDouble.empty();
        target = place;
        begun = clock.instant();
        GoalSource<ActuatorState, Result> next = new GoalSource<>(() -> {
            send(0);
            end(new Result.Cancelled());
        });
        goal = next;
        if (!server.isConnected()) {
            end(new Result.Stuck(position, server.reason()));
        }
        return next;
    }

    private void end(Result ending) {
        GoalSource<ActuatorState, Result> ended = goal;
        goal = null;
        if (ended != null) {
            ended.end(ending);
        }
    }

    @Override
    public void command(double wanted) {
        if (!Double.isFinite(wanted)) {
            throw new IllegalArgumentException("A speed must be finite, not '%s'.".formatted(wanted));
        }
        end(new Result.Cancelled());
        if (!base.enabled()) {
            return;
        }
        double feasible = Interval.around0(part.maxSpeed()).clamp(wanted);
        speed = OptionalDouble.of(feasible);
        wantedAt = clock.instant();
        send(feasible);
    }

    private void send(double wanted) {
        server.command(address(), Actarray.SPEED, new Actarray.Speed(0, (float) wanted));
    }

    @Override
    public void look(Instant now) {
        super.look(now);
        if (speed.isPresent() && wantedAt.plus(watchdog).isBefore(now.plus(RemoteServer.LOOK))) {
            speed = OptionalDouble.empty();
            send(0);
        }
        if (goal != null && base.enabled() && begun.isBefore(now.minus(PATIENCE))) {
            end(new Result.Stuck(position, "It does not get there."));
        }
    }

    @Override
    public void lost(String reason) {
        speed = OptionalDouble.empty();
        end(new Result.Stuck(position, reason));
        super.lost(reason);
    }
}
