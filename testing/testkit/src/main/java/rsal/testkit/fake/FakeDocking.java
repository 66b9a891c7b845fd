package rsal.testkit.fake;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.Device;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.Docking;
import rsal.device.GoalHandle;
import rsal.device.GoalSource;
import rsal.robot.DeviceDriver;
import rsal.settings.Arguments;
import rsal.time.Phase;
import rsal.time.Scheduler;

/// Drives some centimeters onto a dock, and the same back. It knows the dock `home`, and any place; docks at places
/// with an x below 0 are not there.
public final class FakeDocking extends DeviceCore implements Docking {
    private static final double SPEED = 0.1; // m/s
    private static final Duration LOOKING = Duration.ofSeconds(1);
    private static final Duration DRIVING = Duration.ofSeconds(3); // until it is there

    private final FakeDriveBase base;
    private final Scheduler scheduler;
    private @Nullable Attempt attempt;

    /// @param direction of driving: 1 onto a dock, -1 off it
    private record Attempt(double direction, Instant since, GoalSource<Progress, Result> source) {}

    private FakeDocking(DeviceInfo info, FakeDriveBase base, Scheduler scheduler) {
        super(info);
        this.base = base;
        this.scheduler = scheduler;
    }

    @Override
    public GoalHandle<Progress, Result> dock(String dock) {
        return begin(1, dock.equals("home") ? "" : "There is no dock '%s'.".formatted(dock));
    }

    @Override
    public GoalHandle<Progress, Result> dock(Pose2d mapFromDock, String type) {
        if (!mapFromDock.isFinite()) {
            throw new IllegalArgumentException("A dock must be at a finite place, not '%s'.".formatted(mapFromDock));
        }
        return begin(1, mapFromDock.x() < 0 ? "There is no dock at %s.".formatted(mapFromDock) : "");
    }

    @Override
    public GoalHandle<Progress, Result> undock() {
        return begin(-1, "");
    }

    /// @param why it can't; empty when it can
    private GoalHandle<Progress, Result> begin(double direction, String why) {
        end(new Result.Cancelled("Another goal was given."));
        var next = new Attempt(
                direction, scheduler.instant(), new GoalSource<>(() -> end(new Result.Cancelled("It was asked to."))));
        attempt = next;
        if (!base.enabled()) {
            end(new Result.Failed("The motors are off."));
        } else if (!why.isEmpty()) {
            scheduler.execute(() -> {
                if (next.equals(attempt)) {
                    end(new Result.Failed(why));
                }
            });
        }
        return next.source;
    }

    private void end(Result result) {
        Attempt ended = attempt;
        if (ended != null) {
            attempt = null;
            base.command(Twist2d.STOP);
            ended.source.end(result);
        }
    }

    private void work() {
        Attempt now = attempt;
        if (now == null) {
            return;
        }
        Duration working = Duration.between(now.since, scheduler.instant());
        boolean isLooking = working.compareTo(LOOKING) < 0;
        now.source.publish(new Stamped<>(
                scheduler.instant(), "map", new Progress(isLooking ? Stage.DETECTING : Stage.MOVING, 0, working)));
        if (!base.enabled()) {
            end(new Result.Cancelled("The motors are off."));
        } else if (working.compareTo(LOOKING.plus(DRIVING)) > 0) {
            end(new Result.Reached());
        } else if (!isLooking) {
            base.command(Twist2d.drive(now.direction * SPEED, 0));
        }
    }

    /// Makes it for a robot of the fake system.
    public static final class Driver implements DeviceDriver {
        @Override
        public String key() {
            return "fake-docking";
        }

        @Override
        public String description() {
            return "Drives straight on for some centimeters.";
        }

        @Override
        public Class<? extends Device> makes() {
            return Docking.class;
        }

        @Override
        public List<Class<? extends Device>> needs() {
            return List.of(FakeDriveBase.class);
        }

        @Override
        public FakeDocking create(Context context, Arguments arguments) {
            var docking = new FakeDocking(
                    new DeviceInfo(context.robot().id(), context.name(), key()),
                    context.robot().require(FakeDriveBase.class),
                    context.scheduler());
            context.scheduler().every(FakeSystem.STEP, Phase.DEVICES, docking::work);
            return docking;
        }
    }
}
