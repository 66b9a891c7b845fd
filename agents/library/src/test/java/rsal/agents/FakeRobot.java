package rsal.agents;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.CompletionStage;
import org.jspecify.annotations.Nullable;
import rsal.behavior.Pilot;
import rsal.behavior.PilotDriver;
import rsal.data.Covariance2d;
import rsal.data.Footprint;
import rsal.data.OccupancyGrid;
import rsal.data.Odometry;
import rsal.data.Path2d;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.DriveBase;
import rsal.device.GoalHandle;
import rsal.device.GoalSource;
import rsal.device.Localizer;
import rsal.device.Navigator;
import rsal.device.SensorCore;
import rsal.robot.DeviceDriver;
import rsal.robot.Robot;
import rsal.robot.RobotModel;
import rsal.settings.Arguments;
import rsal.time.Phase;
import rsal.time.Scheduler;

/// A robot whose devices a test moves by hand and reads afterwards. Its pilot is a real one; it drives while the
/// base has readings ([#wakeBase]).
public final class FakeRobot {
    public final Base base;
    public final Local localizer;
    public final Nav navigator;
    public final Pilot pilot;
    public final FakePlaces places; // which a test gives the robot
    public final Robot robot;
    private final Scheduler scheduler;

    public FakeRobot(String id, String role, Scheduler scheduler) {
        this.scheduler = scheduler;
        base = new Base(id);
        localizer = new Local(id);
        navigator = new Nav(id);
        places = new FakePlaces(id);
        pilot = pilot(new Robot(id, role, model(), List.of(base)), scheduler);
        robot = new Robot(id, role, model(), List.of(base, localizer, navigator, pilot));
    }

    private static Pilot pilot(Robot robot, Scheduler scheduler) {
        var driver = new PilotDriver();
        var map = new OccupancyGrid(1, 1, 1, 0, 0, new byte[1]);
        var context = new DeviceDriver.Context("pilot", robot, map, Optional.empty(), scheduler, new Random(1));
        return driver.create(context, Arguments.defaults(driver.parameters()));
    }

    private static RobotModel model() {
        var drive = new RobotModel.Drive(1, 2, 1, 2, new RobotModel.OdometryNoise(0, 0, 0));
        return new RobotModel("fake", "Fake", Footprint.box(0.4, 0.4, new Point2d(0, 0)), drive, Map.of());
    }

    /// The same robot with only its base.
    public Robot withoutLocalizer() {
        return new Robot(robot.id(), robot.role(), robot.model(), List.of(base));
    }

    /// The base tells ten times a second that it stands where odometry began.
    public void wakeBase() {
        scheduler.every(Duration.ofMillis(100), Phase.WORLD, () -> base.roll(Pose2d.ORIGIN, scheduler.instant()));
    }

    /// The localizer finds the robot here.
    public void isAt(double x, double y) {
        localizer.find(new Pose2d(x, y, 0), scheduler.instant());
    }

    public static final class Base extends SensorCore<Odometry> implements DriveBase {
        public final List<Twist2d> commands = new ArrayList<>();

        Base(String robot) {
            super(new DeviceInfo(robot, "base", "fake"));
        }

        public void roll(Pose2d odomFromBase, Instant time) {
            deliver(new Stamped<>(time, info().robot() + "/odom", new Odometry(odomFromBase, Twist2d.STOP, false)));
        }

        @Override
        public void command(Twist2d velocity) {
            commands.add(velocity);
        }

        @Override
        public void enable(boolean enabled) {}

        @Override
        public boolean enabled() {
            return true;
        }

        @Override
        public void resetOdometry(Pose2d odomFromBase) {}
    }

    public static final class Local extends SensorCore<PoseEstimate> implements Localizer {
        Local(String robot) {
            super(new DeviceInfo(robot, "localizer", "fake"));
        }

        void find(Pose2d mapFromBase, Instant time) {
            var estimate = PoseEstimate.of(mapFromBase, Covariance2d.ofDeviations(0.1, 0.1, 0.1));
            deliver(new Stamped<>(time, "map", estimate));
        }

        @Override
        public CompletionStage<Void> relocalize(PoseEstimate belief) {
            throw new UnsupportedOperationException("Agents leave that to people.");
        }
    }

    /// Notes each goal; a drive goes on until the test ends it or another begins.
    public static final class Nav extends DeviceCore implements Navigator {
        public final List<Pose2d> goals = new ArrayList<>();
        private @Nullable GoalSource<Progress, Result> inProgress;

        Nav(String robot) {
            super(new DeviceInfo(robot, "navigator", "fake"));
        }

        public boolean driving() {
            return inProgress != null && !inProgress.ended();
        }

        public void end(Result result) {
            inProgress.end(result);
        }

        public void reach() {
            end(new Result.Reached(goals.getLast()));
        }

        @Override
        public GoalHandle<Progress, Result> goTo(Pose2d mapFromGoal, Tolerance tolerance) {
            if (driving()) {
                end(Result.Cancelled.by(mapFromGoal));
            }
            goals.add(mapFromGoal);
            inProgress = new GoalSource<>(() -> end(Result.Cancelled.asked()));
            return inProgress;
        }

        @Override
        public void pause() {}

        @Override
        public void resume() {}

        @Override
        public boolean paused() {
            return false;
        }

        @Override
        public Optional<Pose2d> goal() {
            return driving() ? Optional.of(goals.getLast()) : Optional.empty();
        }

        @Override
        public Path2d path() {
            return Path2d.EMPTY;
        }
    }

    public static Navigator.Result stuck() {
        return new Navigator.Result.Stuck(Pose2d.ORIGIN, Duration.ofSeconds(20), "A box stands in its way.");
    }
}
