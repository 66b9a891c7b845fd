package rsal.player.bridge;

import java.time.Duration;
import java.util.Optional;
import rsal.data.Footprint;
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
import rsal.player.wire.Kind;
import rsal.player.wire.MalformedException;
import rsal.player.wire.Packet;
import rsal.time.Scheduler;

/// A base as `position2d`. A velocity holds until the next one, as Player's clients expect, and ours do not: it is said
/// again and again, until no client is left.
final class OfferedBase extends Offered {
    private static final Duration AGAIN = Duration.ofMillis(100);

    private final DriveBase base;
    private final Footprint footprint;
    private final double height;
    private Optional<Twist2d> wanted = Optional.empty();

    /// @param height of the robot [m]
    OfferedBase(int index, DriveBase base, Footprint footprint, double height, Scheduler scheduler) {
        super(Interface.POSITION2D, index, base.info(), scheduler);
        this.base = base;
        this.footprint = footprint;
        this.height = height;
    }

    @Override
    Subscription listen() {
        var repeating = scheduler().every(AGAIN, () -> wanted.ifPresent(base::command));
        Subscription telling = base.subscribe(this::tell);
        return () -> {
            repeating.cancel();
            telling.cancel();
        };
    }

    private void tell(Stamped<Odometry> reading) {
        Odometry odometry = reading.value();
        Twist2d velocity = odometry.velocity();
        publish(
                Position2d.STATE,
                reading.time(),
                new Position2d.State(
                        pose(odometry.odomFromBase()),
                        new Pose(velocity.vx(), velocity.vy(), velocity.omega()),
                        odometry.stalled() ? 1 : 0));
    }

    @Override
    public boolean understands(Kind kind, int subtype) {
        return switch (kind) {
            case COMMAND -> subtype == Position2d.VELOCITY;
            case REQUEST -> subtype >= Position2d.GEOMETRY && subtype <= Position2d.RESET_ODOMETRY;
            default -> false;
        };
    }

    @Override
    Optional<Answer> answer(Packet request) throws MalformedException {
        switch (request.header().subtype()) {
            case Position2d.GEOMETRY -> {
                return Optional.of(new Answer.Told(geometry()));
            }
            case Position2d.MOTORS -> {
                boolean on = request.body(Position2d.Motors.class).on() != 0;
                wanted = wanted.filter(_ -> on);
                base.enable(on);
            }
            case Position2d.VELOCITY_MODE, Position2d.POSITION_MODE -> {} // there is one way only
            case Position2d.SET_ODOMETRY -> {
                Pose2d odomFromBase =
                        pose(request.body(Position2d.Odometry.class).odomFromBase());
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

    private Position2d.Geometry geometry() {
        double minX = footprint.corners().stream().mapToDouble(Point2d::x).min().orElseThrow();
        double maxX = footprint.corners().stream().mapToDouble(Point2d::x).max().orElseThrow();
        double minY = footprint.corners().stream().mapToDouble(Point2d::y).min().orElseThrow();
        double maxY = footprint.corners().stream().mapToDouble(Point2d::y).max().orElseThrow();
        return new Position2d.Geometry(
                new Pose3((minX + maxX) / 2, (minY + maxY) / 2, 0, 0, 0, 0),
                new Box3(maxY - minY, maxX - minX, height));
    }

    @Override
    void obey(Packet command) throws MalformedException {
        if (command.header().subtype() == Position2d.VELOCITY) {
            Pose velocity = command.body(Position2d.Velocity.class).velocity();
            var twist = new Twist2d(velocity.x(), velocity.y(), velocity.theta());
            base.command(twist); // refuses what is not finite
            wanted = Optional.of(twist);
        }
    }

    @Override
    void idle() {
        wanted.ifPresent(_ -> base.command(Twist2d.STOP));
        wanted = Optional.empty();
    }
}
