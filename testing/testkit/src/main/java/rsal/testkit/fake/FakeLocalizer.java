package rsal.testkit.fake;

import java.time.InstantSource;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.Stamped;
import rsal.device.Device;
import rsal.device.DeviceInfo;
import rsal.device.Localizer;
import rsal.device.SensorCore;
import rsal.robot.DeviceDriver;
import rsal.settings.Arguments;
import rsal.time.Phase;

/// Knows where the robot is, until it is told a belief: then it is wrong by as much as that was, and as sure.
public final class FakeLocalizer extends SensorCore<PoseEstimate> implements Localizer {
    private final FakeDriveBase base;
    private final InstantSource clock;
    private Pose2d baseFromBelief = Pose2d.ORIGIN;
    private PoseEstimate belief = PoseEstimate.of(Pose2d.ORIGIN, Covariance2d.ofDeviations(0.05, 0.05, 0.02));

    private FakeLocalizer(DeviceInfo info, FakeDriveBase base, InstantSource clock) {
        super(info);
        this.base = base;
        this.clock = clock;
    }

    @Override
    public CompletionStage<Void> relocalize(PoseEstimate belief) {
        baseFromBelief = base.mapFromBase().inverse().compose(belief.mapFromBase());
        this.belief = belief;
        var done = new CompletableFuture<Void>();
        next().thenAccept(_ -> done.complete(null));
        return done;
    }

    private void look() {
        Pose2d believed = base.mapFromBase().compose(baseFromBelief);
        var hypothesis = new PoseEstimate.Hypothesis(1, believed, belief.covariance());
        deliver(new Stamped<>(
                clock.instant(),
                "map",
                new PoseEstimate(
                        believed, belief.covariance(), List.of(hypothesis), belief.confidence(), belief.quality())));
    }

    /// Makes it for a robot of the fake system.
    public static final class Driver implements DeviceDriver {
        @Override
        public String key() {
            return "fake-localizer";
        }

        @Override
        public String description() {
            return "Says what a test tells it to.";
        }

        @Override
        public Class<? extends Device> makes() {
            return Localizer.class;
        }

        @Override
        public List<Class<? extends Device>> needs() {
            return List.of(FakeDriveBase.class);
        }

        @Override
        public FakeLocalizer create(Context context, Arguments arguments) {
            var localizer = new FakeLocalizer(
                    new DeviceInfo(context.robot().id(), context.name(), key()),
                    context.robot().require(FakeDriveBase.class),
                    context.scheduler());
            context.scheduler().every(FakeSystem.STEP, Phase.DEVICES, localizer::look);
            return localizer;
        }
    }
}
