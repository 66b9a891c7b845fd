package rsal.testkit.fake;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.data.Angles;
import rsal.data.OccupancyGrid;
import rsal.data.Path2d;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.Device;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.GoalHandle;
import rsal.device.GoalSource;
import rsal.device.Navigator;
import rsal.device.Planner;
import rsal.robot.DeviceDriver;
import rsal.settings.Arguments;
import rsal.time.Phase;
import rsal.time.Scheduler;

/// Turns to the goal, drives straight there, turns as asked. It remembers every goal.
public final class FakeNavigator extends DeviceCore implements Navigator {
    private static final double SPEED = 0.4;
    private static final double GAIN = 2;

    private final FakeDriveBase base;
    private final OccupancyGrid map;
    private final Scheduler scheduler;
    private final List<Pose2d> goals = new ArrayList<>();
    private @Nullable Drive drive;
    private boolean paused;

    private FakeNavigator(DeviceInfo info, FakeDriveBase base, OccupancyGrid map, Scheduler scheduler) {
        super(info);
        this.base = base;
        this.map = map;
        this.scheduler = scheduler;
    }

    /// All goals so far, the oldest first.
    public List<Pose2d> goals() {
        return List.copyOf(goals);
    }

    @Override
    public GoalHandle<Progress, Result> goTo(Pose2d mapFromGoal, Tolerance tolerance) {
        if (!mapFromGoal.isFinite()) {
            throw new IllegalArgumentException("A goal must be finite, not '%s'.".formatted(mapFromGoal));
        }
        goals.add(mapFromGoal);
        if (drive != null) {
            end(drive, Result.Cancelled.by(mapFromGoal));
        }
        var next = new Drive(mapFromGoal, tolerance, scheduler.instant());
        drive = next;
        if (FakePlanner.straight(map, base.mapFromBase(), mapFromGoal) instanceof Planner.Result.NoPath(String why)) {
            scheduler.execute(() -> end(next, new Result.NoPath(why)));
        }
        return next.source;
    }

    @Override
    public void pause() {
        paused = true;
        base.command(Twist2d.STOP);
    }

    @Override
    public void resume() {
        paused = false;
    }

    @Override
    public boolean paused() {
        return paused;
    }

    @Override
    public Optional<Pose2d> goal() {
        return Optional.ofNullable(drive).map(d -> d.goal);
    }

    @Override
    public Path2d path() {
        return drive == null
                ? Path2d.EMPTY
                : new Path2d(List.of(base.mapFromBase().position(), drive.goal.position()));
    }

    private void work() {
        Drive now = drive;
        if (now == null || paused) {
            return;
        }
        Pose2d at = base.mapFromBase();
        boolean there = at.distanceTo(now.goal) <= now.tolerance.distance();
        double off = there ? Angles.difference(at.theta(), now.goal.theta()) : at.bearingTo(now.goal.position());
        if (there && Math.abs(off) <= now.tolerance.angle()) {
            end(now, new Result.Reached(at));
            return;
        }
        double forward = there || Math.abs(off) > 0.2 ? 0 : SPEED;
        base.command(Twist2d.drive(forward, GAIN * off));
        var progress = new Progress(
                at, at.distanceTo(now.goal), now.goal.position(), Duration.between(now.since, scheduler.instant()));
        now.source.publish(new Stamped<>(scheduler.instant(), "map", progress));
    }

    private void end(Drive ended, Result ending) {
        if (drive == ended) {
            drive = null;
            base.command(Twist2d.STOP);
        }
        ended.source.end(ending);
    }

    private final class Drive {
        private final Pose2d goal;
        private final Tolerance tolerance;
        private final Instant since;
        private final GoalSource<Progress, Result> source;

        Drive(Pose2d goal, Tolerance tolerance, Instant since) {
            this.goal = goal;
            this.tolerance = tolerance;
            this.since = since;
            this.source = new GoalSource<>(() -> end(this, Result.Cancelled.asked()));
        }
    }

    /// Makes it for a robot of the fake system.
    public static final class Driver implements DeviceDriver {
        @Override
        public String key() {
            return "fake-navigator";
        }

        @Override
        public String description() {
            return "Ends goals as a test tells it to.";
        }

        @Override
        public Class<? extends Device> makes() {
            return Navigator.class;
        }

        @Override
        public List<Class<? extends Device>> needs() {
            return List.of(FakeDriveBase.class);
        }

        @Override
        public FakeNavigator create(Context context, Arguments arguments) {
            var navigator = new FakeNavigator(
                    new DeviceInfo(context.robot().id(), context.name(), key()),
                    context.robot().require(FakeDriveBase.class),
                    context.map(),
                    context.scheduler());
            context.scheduler().every(FakeSystem.STEP, Phase.DEVICES, navigator::work);
            return navigator;
        }
    }
}
