package rsal.player.bridge;

import java.util.Optional;
import rsal.data.Odometry;
import rsal.data.PoseEstimate;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.DriveBase;
import rsal.device.Localizer;
import rsal.player.message.Interface;
import rsal.player.message.Pose;
import rsal.player.message.Position2d;
import rsal.player.wire.MessageKind;
import rsal.robot.Robot;
import rsal.time.Scheduler;

/// Where a localizer believes a robot to be as `position2d` that takes no commands, as Player's `amcl` has it.
final class OfferedPose extends OfferedSensor<PoseEstimate> {
    private final Robot robot;

    OfferedPose(int index, Localizer localizer, Robot robot, Scheduler scheduler) {
        super(Interface.POSITION2D, index, localizer, scheduler);
        this.robot = robot;
    }

    @Override
    void publish(Stamped<PoseEstimate> reading) {
        Optional<Odometry> odometry =
                robot.find(DriveBase.class).flatMap(DriveBase::latest).map(Stamped::value);
        Twist2d velocity = odometry.map(Odometry::velocity).orElse(Twist2d.STOP);
        publish(
                Position2d.STATE,
                reading.time(),
                new Position2d.State(
                        Pose.of(reading.value().mapFromBase()),
                        new Pose(velocity.vx(), velocity.vy(), velocity.omega()),
                        odometry.map(Odometry::stalled).orElse(false) ? 1 : 0));
    }

    @Override
    public boolean understands(MessageKind kind, int subtype) {
        return kind == MessageKind.REQUEST && subtype == Position2d.GEOMETRY;
    }

    @Override
    Record body(PoseEstimate newest, int subtype) {
        return OfferedBase.geometry(robot.model());
    }
}
