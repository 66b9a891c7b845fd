package rsal.player.bridge;

import java.time.Duration;
import java.util.Optional;
import rsal.data.Interval;
import rsal.data.Odometry;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.DriveBase;
import rsal.device.Subscription;
import rsal.player.message.Box3;
import rsal.player.message.Interface;
import rsal.player.message.Pose;
import rsal.player.message.Pose3;
import rsal.player.message.Position2d;
import rsal.player.wire.MalformedException;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Drive;
import rsal.robot.RobotModel.Steering;
import rsal.system.CommandTimeout;
import rsal.system.CommandWatch;
import rsal.time.Scheduler;

/// A base as `position2d`. What a client wants is said again and again, as Player's clients expect it to hold
/// and ours do not: until it wants something else, no client is left, or no command came for too long
/// ([CommandTimeout]). A goal has an end of its own, so that it holds while clients are silent.
final class OfferedBase extends Offered implements ExclusiveControl.Holder {
    private static final Duration AGAIN = Duration.ofMillis(100);

    private final DriveBase base;
    private final RobotModel model;
    private final Optional<Guide> guide;
    private final ExclusiveControl control;
    private final CommandTimeout timeout;
    private final CommandWatch watch;
    private Optional<ClientCommand> wanted = Optional.empty();
    private boolean lasting; // whether what is wanted ends by itself

    /// @param guide takes it to its goals; without one it minds nothing that is in the way
    /// @param timeout of velocities
    OfferedBase(
            int index,
            DriveBase base,
            RobotModel model,
            Optional<Guide> guide,
            ExclusiveControl control,
            CommandTimeout timeout,
            Scheduler scheduler) {
        super(Interface.POSITION2D, index, base.info(), scheduler);
        this.base = base;
        this.model = model;
        this.guide = guide;
        this.control = control;
        this.timeout = timeout;
        this.watch = timeout.watch();
    }

    @Override
    Subscription listen() {
        var repeating = scheduler().every(AGAIN, this::drive);
        Subscription publishing = base.subscribe(this::publish);
        return () -> {
            repeating.cancel();
            publishing.cancel();
        };
    }

    @Override
    void heard(Packet command) {
        watch.heard(timeout.now());
    }

    private void drive() {
        guide.ifPresent(Guide::begin);
        if (wanted.isPresent() && !lasting && watch.isSilent(timeout.now(), AGAIN)) {
            wanted = Optional.empty();
            base.command(Twist2d.STOP);
        }
        Optional<Odometry> odometry = base.latest().map(Stamped::value);
        if (wanted.isPresent() && odometry.isPresent()) {
            Optional<Twist2d> next = wanted.get().now(odometry.get());
            base.command(next.filter(Twist2d::isFinite).orElse(Twist2d.STOP)); // odometry may be too far off
            wanted = wanted.filter(_ -> next.isPresent());
        }
    }

    private void publish(Stamped<Odometry> reading) {
        Odometry odometry = reading.value();
        Twist2d velocity = odometry.velocity();
        publish(
                Position2d.STATE,
                reading.time(),
                new Position2d.State(
                        Pose.of(odometry.odomFromBase()),
                        new Pose(velocity.vx(), velocity.vy(), velocity.omega()),
                        odometry.stalled() ? 1 : 0));
    }

    @Override
    public boolean understands(MessageKind kind, int subtype) {
        return switch (kind) {
            case COMMAND ->
                switch (subtype) {
                    case Position2d.VELOCITY -> true;
                    case Position2d.GOAL, Position2d.VELOCITY_HEADING -> drives().turnsInPlace();
                    case Position2d.CAR -> drives().steering() instanceof Steering.Car;
                    default -> false;
                };
            case REQUEST -> subtype >= Position2d.GEOMETRY && subtype <= Position2d.RESET_ODOMETRY;
            default -> false;
        };
    }

    private Drive drives() {
        return model.drive();
    }

    @Override
    Optional<Answer> answer(Packet request) throws MalformedException {
        switch (request.header().subtype()) {
            case Position2d.GEOMETRY -> {
                return Optional.of(new Answer.Reported(geometry(model)));
            }
            case Position2d.MOTORS -> {
                boolean on = request.body(Position2d.Motors.class).on() != 0;
                if (!on) {
                    letGo();
                }
                base.enable(on);
            }
            case Position2d.VELOCITY_MODE, Position2d.POSITION_MODE -> {} // what it is told says which
            case Position2d.SET_ODOMETRY -> {
                Pose2d odomFromBase =
                        request.body(Position2d.Odometry.class).odomFromBase().to2d();
                if (!odomFromBase.isFinite()) {
                    return Optional.of(new Answer.Refused());
                }
                base.resetOdometry(odomFromBase);
            }
            case Position2d.RESET_ODOMETRY -> base.resetOdometry(Pose2d.ORIGIN);
            default -> {
                return Optional.empty();
            }
        }
        return Optional.of(new Answer.Done());
    }

    static Position2d.Geometry geometry(RobotModel model) {
        var corners = model.footprint().corners();
        double minX = corners.stream().mapToDouble(Point2d::x).min().orElseThrow();
        double maxX = corners.stream().mapToDouble(Point2d::x).max().orElseThrow();
        double minY = corners.stream().mapToDouble(Point2d::y).min().orElseThrow();
        double maxY = corners.stream().mapToDouble(Point2d::y).max().orElseThrow();
        return new Position2d.Geometry(
                new Pose3((minX + maxX) / 2, (minY + maxY) / 2, 0, 0, 0, 0),
                new Box3(maxY - minY, maxX - minX, model.body().top()));
    }

    @Override
    void obey(Packet command) throws MalformedException {
        int subtype = command.header().subtype();
        if (!understands(MessageKind.COMMAND, subtype)) {
            return;
        }
        if (subtype == Position2d.GOAL && guide.isPresent()) {
            Pose2d goal = goal(command);
            control.take(this);
            wanted = Optional.empty();
            guide.get().goTo(goal);
        } else {
            ClientCommand wish = wish(command);
            control.take(this);
            guide.ifPresent(Guide::letGo);
            wanted = Optional.of(wish);
            lasting = subtype == Position2d.GOAL;
            drive();
        }
    }

    private static Pose2d goal(Packet command) throws MalformedException {
        Pose2d goal = command.body(Position2d.Goal.class).odomFromGoal().to2d();
        return finite(goal, goal.isFinite());
    }

    /// @throws IllegalArgumentException when it is not finite
    private ClientCommand wish(Packet command) throws MalformedException {
        return switch (command.header().subtype()) {
            case Position2d.GOAL -> Steps.to(goal(command), drives());
            case Position2d.VELOCITY_HEADING -> {
                var reported = command.body(Position2d.VelocityHeading.class);
                boolean isFinite = Double.isFinite(reported.velocity()) && Double.isFinite(reported.heading());
                yield Steps.along(finite(reported, isFinite).velocity(), reported.heading(), drives());
            }
            case Position2d.CAR -> constant(steered(command.body(Position2d.Car.class)));
            default -> {
                Pose velocity = command.body(Position2d.Velocity.class).velocity();
                yield constant(new Twist2d(velocity.x(), velocity.y(), velocity.theta()));
            }
        };
    }

    private Twist2d steered(Position2d.Car reported) {
        var car = (Steering.Car) drives().steering();
        double angle = Interval.around0(car.maxSteeringAngle()).clamp(reported.steering());
        return Twist2d.drive(reported.velocity(), reported.velocity() * Math.tan(angle) / car.wheelbase());
    }

    private static ClientCommand constant(Twist2d velocity) {
        Optional<Twist2d> always = Optional.of(finite(velocity, velocity.isFinite()));
        return _ -> always;
    }

    private static <T> T finite(T value, boolean isFinite) {
        if (!isFinite) {
            throw new IllegalArgumentException("A base can't do '%s'.".formatted(value));
        }
        return value;
    }

    @Override
    public void letGo() {
        wanted = Optional.empty();
        guide.ifPresent(Guide::letGo);
    }

    @Override
    void idle() {
        wanted.ifPresent(_ -> base.command(Twist2d.STOP));
        letGo();
    }
}
