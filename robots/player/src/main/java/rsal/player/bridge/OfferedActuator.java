package rsal.player.bridge;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import rsal.data.ActuatorState;
import rsal.data.ActuatorState.Joint;
import rsal.data.Stamped;
import rsal.device.Actuator;
import rsal.device.Subscription;
import rsal.player.message.Actarray;
import rsal.player.message.Interface;
import rsal.player.message.Orientation;
import rsal.player.message.Point3;
import rsal.player.wire.MalformedException;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;
import rsal.system.CommandTimeout;
import rsal.system.CommandWatch;
import rsal.time.Scheduler;

/// An actuator as `actarray` of one joint. As with a base, a speed holds until it is told something else, no client is
/// left, or no command came for too long.
final class OfferedActuator extends OfferedSensor<ActuatorState> {
    private static final Duration AGAIN = Duration.ofMillis(100);
    private static final int LINEAR = 1;
    private static final int ROTARY = 2;

    private final Actuator actuator;
    private final CommandTimeout timeout;
    private final CommandWatch watch;
    private OptionalDouble speed = OptionalDouble.empty();

    OfferedActuator(int index, Actuator actuator, CommandTimeout timeout, Scheduler scheduler) {
        super(Interface.ACTARRAY, index, actuator, scheduler);
        this.actuator = actuator;
        this.timeout = timeout;
        this.watch = timeout.watch();
    }

    @Override
    void heard(Packet command) {
        watch.heard(timeout.now());
    }

    private void move() {
        if (watch.isSilent(timeout.now(), AGAIN)) {
            idle();
        }
        speed.ifPresent(actuator::command);
    }

    @Override
    Subscription listen() {
        var repeating = scheduler().every(AGAIN, this::move);
        Subscription publishing = super.listen();
        return () -> {
            repeating.cancel();
            publishing.cancel();
        };
    }

    @Override
    void publish(Stamped<ActuatorState> reading) {
        ActuatorState state = reading.value();
        int motion = switch (state.motion()) {
            case IDLE -> Actarray.IDLE;
            case MOVING -> Actarray.MOVING;
            case STALLED -> Actarray.STALLED;
        };
        var joint = new Actarray.Joint((float) state.position(), (float) state.speed(), 0, 0, motion);
        publish(Actarray.STATE, reading.time(), new Actarray.State(List.of(joint), 1));
    }

    @Override
    public boolean understands(MessageKind kind, int subtype) {
        return Order.isOne(kind, subtype) || (kind == MessageKind.REQUEST && subtype == Actarray.GEOMETRY);
    }

    @Override
    Record body(ActuatorState newest, int subtype) {
        float least = (float) newest.limits().least();
        float most = (float) newest.limits().most();
        return new Actarray.Geometry(
                List.of(new Actarray.JointGeometry(
                        newest.joint() == Joint.LINEAR ? LINEAR : ROTARY,
                        newest.joint() == Joint.LINEAR ? most - least : 0,
                        new Orientation(0, 0, 0),
                        newest.joint() == Joint.LINEAR ? new Point3(1, 0, 0) : new Point3(0, 0, 1),
                        least,
                        (least + most) / 2,
                        most,
                        least,
                        0,
                        0)),
                new Point3(0, 0, 0),
                new Orientation(0, 0, 0));
    }

    @Override
    void obey(Packet command) throws MalformedException {
        Optional<Order> order = Order.of(command);
        if (order.isEmpty()) {
            return;
        }
        speed = OptionalDouble.empty();
        switch (order.get()) {
            case Order.Position(double position) -> actuator.goTo(position); // refuses what is not finite
            case Order.Speed(double wanted) -> {
                actuator.command(wanted); // the same
                speed = OptionalDouble.of(wanted);
            }
            case Order.Home _ -> actuator.home();
        }
    }

    @Override
    void idle() {
        speed.ifPresent(_ -> actuator.command(0));
        speed = OptionalDouble.empty();
    }

    /// What a client wants of the first joint, which is the only one.
    sealed interface Order {
        record Position(double position) implements Order {}

        record Speed(double speed) implements Order {}

        record Home() implements Order {}

        static boolean isOne(MessageKind kind, int subtype) {
            return kind == MessageKind.COMMAND && subtype >= Actarray.POSITION && subtype <= Actarray.HOME;
        }

        /// Empty when it is about another joint, or about none.
        static Optional<Order> of(Packet command) throws MalformedException {
            return switch (command.header().subtype()) {
                case Actarray.POSITION -> {
                    var reported = command.body(Actarray.Position.class);
                    yield first(reported.joint(), new Position(reported.position()));
                }
                case Actarray.POSITIONS -> {
                    float[] reported = command.body(Actarray.Positions.class).positions();
                    yield reported.length == 0 ? Optional.empty() : Optional.of(new Position(reported[0]));
                }
                case Actarray.SPEED -> {
                    var reported = command.body(Actarray.Speed.class);
                    yield first(reported.joint(), new Speed(reported.speed()));
                }
                case Actarray.SPEEDS -> {
                    float[] reported = command.body(Actarray.Speeds.class).speeds();
                    yield reported.length == 0 ? Optional.empty() : Optional.of(new Speed(reported[0]));
                }
                case Actarray.HOME -> {
                    int joint = command.body(Actarray.Home.class).joint();
                    yield first(Math.max(0, joint), new Home()); // -1 is all of them
                }
                default -> Optional.empty();
            };
        }

        private static Optional<Order> first(int joint, Order order) {
            return joint == 0 ? Optional.of(order) : Optional.empty();
        }
    }
}
