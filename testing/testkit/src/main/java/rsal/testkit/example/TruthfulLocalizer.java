package rsal.testkit.example;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import rsal.data.Covariance2d;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.Stamped;
import rsal.device.Device;
import rsal.device.DeviceInfo;
import rsal.device.DriveBase;
import rsal.device.LaserScanner;
import rsal.device.Localizer;
import rsal.device.SensorCore;
import rsal.robot.DeviceDriver;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Believes in its odometry, but for a constant error.
public final class TruthfulLocalizer implements DeviceDriver {
    private static final Parameter<Double> ERROR =
            Parameter.number("error", 0, 0, 10, "m", "How far its readings are off.");

    @Override
    public String key() {
        return "truthful";
    }

    @Override
    public String description() {
        return "Believes in its odometry, but for a constant error.";
    }

    @Override
    public Class<? extends Device> makes() {
        return Localizer.class;
    }

    @Override
    public List<Class<? extends Device>> needs() {
        return List.of(DriveBase.class, LaserScanner.class);
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(ERROR);
    }

    @Override
    public Device create(Context context, Arguments arguments) {
        var info = new DeviceInfo(context.robot().id(), context.name(), key());
        return new Odometer(
                info,
                context.robot().require(DriveBase.class),
                context.mapFromBase().orElseThrow(),
                arguments.get(ERROR));
    }

    private static final class Odometer extends SensorCore<PoseEstimate> implements Localizer {
        private final double error;
        private Pose2d mapFromOdom;

        Odometer(DeviceInfo info, DriveBase base, Pose2d mapFromBase, double error) {
            super(info);
            this.error = error;
            this.mapFromOdom = mapFromBase;
            base.subscribe(this::moved);
        }

        private void moved(Stamped<Odometry> odometry) {
            Pose2d pose = mapFromOdom.compose(odometry.value().odomFromBase());
            var estimate = PoseEstimate.of(
                    new Pose2d(pose.x() + error, pose.y(), pose.theta()), Covariance2d.ofDeviations(0.1, 0.1, 0.1));
            deliver(new Stamped<>(odometry.time(), "map", estimate));
        }

        @Override
        public CompletionStage<Void> relocalize(PoseEstimate belief) {
            mapFromOdom = belief.mapFromBase();
            return CompletableFuture.completedStage(null);
        }
    }
}
