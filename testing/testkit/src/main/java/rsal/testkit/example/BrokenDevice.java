package rsal.testkit.example;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import rsal.data.ParticleCloud;
import rsal.data.PoseEstimate;
import rsal.data.Stamped;
import rsal.device.Device;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.Localizer;
import rsal.device.SensorCore;
import rsal.robot.DeviceDriver;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.time.Phase;

/// Fails after a second, at once, or when somebody looks at it.
public final class BrokenDevice implements DeviceDriver {
    private static final Parameter<Boolean> AT_ONCE = Parameter.flag("atOnce", false, "Whether it can't even be made.");
    private static final Parameter<Boolean> UNREADABLE =
            Parameter.flag("unreadable", false, "Whether it works, but nobody can look at it.");

    @Override
    public String key() {
        return "broken";
    }

    @Override
    public String description() {
        return "Fails.";
    }

    @Override
    public Class<? extends Device> makes() {
        return Device.class;
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(AT_ONCE, UNREADABLE);
    }

    @Override
    public Device create(Context context, Arguments arguments) {
        if (arguments.get(AT_ONCE)) {
            throw new IllegalStateException("no batteries included");
        }
        var info = new DeviceInfo(context.robot().id(), context.name(), key());
        if (arguments.get(UNREADABLE)) {
            context.scheduler().compute(() -> "busy");
            context.scheduler().compute(() -> "busy, too"); // beside the other: on a thread that helps
            return new Unreadable(info);
        }
        context.scheduler().after(Duration.ofSeconds(1), Phase.DEVICES, () -> {
            throw new IllegalStateException("smoke comes out");
        });
        return new DeviceCore(info) {};
    }

    private static final class Unreadable extends SensorCore<PoseEstimate> implements Localizer {
        Unreadable(DeviceInfo info) {
            super(info);
        }

        @Override
        public Optional<Stamped<ParticleCloud>> particles() {
            throw new IllegalStateException("the display is dark");
        }

        @Override
        public CompletionStage<Void> relocalize(PoseEstimate belief) {
            return CompletableFuture.completedStage(null);
        }
    }
}
