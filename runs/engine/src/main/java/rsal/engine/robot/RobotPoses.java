package rsal.engine.robot;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.device.DriveBase;
import rsal.device.Localizer;
import rsal.robot.Robot;
import rsal.robot.RobotSpec;

/// Where robots are, as far as anybody knows. All calls on the run's thread.
public final class RobotPoses {
    /// The frame of poses in the world.
    public static final String WORLD = "map";

    private final RobotSystems systems;
    private final RobotTeam team;
    private final Map<String, Pose2d> mapFromOdom = new HashMap<>(); // of robots without a localizer

    public RobotPoses(RobotSystems systems, RobotTeam team) {
        this.systems = systems;
        this.team = team;
    }

    /// Whether a robot is simulated here, where touches are counted.
    public boolean isSimulated(String robot) {
        return systems.simulation(robot).isPresent();
    }

    /// Where a robot really is, in the map frame, where that is known.
    public Optional<Pose2d> truth(String robot) {
        return systems.truth(robot);
    }

    /// Where a robot really is, or where a real one believes to be, in the map frame.
    public Optional<Pose2d> mapFromBase(String robot) {
        Optional<Pose2d> truth = truth(robot);
        return truth.isPresent() || isSimulated(robot) ? truth : belief(robot).map(Stamped::value);
    }

    /// Where a robot believes to be, in the map frame.
    Optional<Stamped<Pose2d>> belief(String robot) {
        return team.robot(robot)
                .flatMap(team::localizer)
                .flatMap(Localizer::latest)
                .filter(estimate -> estimate.frame().equals(WORLD))
                .map(estimate -> new Stamped<>(
                        estimate.time(), estimate.frame(), estimate.value().mapFromBase()));
    }

    /// As [#belief]; of a robot without a localizer, where its odometry has taken it from its start.
    public Optional<Stamped<Pose2d>> known(RobotSpec spec) {
        Optional<Robot> robot = team.robot(spec.id());
        return robot.flatMap(team::localizer).isPresent()
                ? belief(spec.id())
                : robot.flatMap(there -> there.find(DriveBase.class))
                        .flatMap(DriveBase::latest)
                        .flatMap(odometry -> spec.mapFromBase()
                                .map(start -> new Stamped<>(
                                        odometry.time(),
                                        WORLD,
                                        fromStart(
                                                spec.id(),
                                                start,
                                                odometry.value().odomFromBase()))));
    }

    private Pose2d fromStart(String robot, Pose2d mapFromStart, Pose2d odomFromBase) {
        return mapFromOdom
                .computeIfAbsent(robot, _ -> mapFromStart.compose(odomFromBase.inverse()))
                .compose(odomFromBase);
    }

    /// A robot has left for good.
    public void leave(String robot) {
        mapFromOdom.remove(robot);
    }
}
