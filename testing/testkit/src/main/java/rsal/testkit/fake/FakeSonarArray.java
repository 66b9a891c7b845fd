package rsal.testkit.fake;

import java.time.InstantSource;
import org.jspecify.annotations.Nullable;
import rsal.data.Pose2d;
import rsal.data.RangeArray;
import rsal.data.Stamped;
import rsal.device.DeviceInfo;
import rsal.device.SonarArray;
import rsal.robot.RobotModel.Part;
import rsal.testkit.ObviousRays;

/// Sonars that see the nearest wall of five rays across their cone exactly, or what a test shows them.
public final class FakeSonarArray extends FakeSensor<RangeArray> implements SonarArray {
    private static final int RAYS = 5;

    private final Part.Sonars part;
    private final FakeDriveBase base;
    private final ObviousRays rays;
    private final InstantSource clock;
    private float @Nullable [] shown;

    FakeSonarArray(DeviceInfo info, Part.Sonars part, FakeDriveBase base, ObviousRays rays, InstantSource clock) {
        super(info);
        this.part = part;
        this.base = base;
        this.rays = rays;
        this.clock = clock;
    }

    /// From now on every reading holds these ranges [m].
    public void show(float... ranges) {
        shown = ranges.clone();
    }

    @Override
    void sense() {
        float[] ranges = shown != null ? shown : look();
        deliver(new Stamped<>(
                clock.instant(),
                info().robot() + "/base_link",
                new RangeArray(part.baseFromSensors(), part.fieldOfView(), part.rangeMin(), part.rangeMax(), ranges)));
    }

    private float[] look() {
        var ranges = new float[part.baseFromSensors().size()];
        for (int i = 0; i < ranges.length; i++) {
            Pose2d mapFromSonar =
                    base.mapFromBase().compose(part.baseFromSensors().get(i));
            double nearest = Double.POSITIVE_INFINITY;
            for (int ray = 0; ray < RAYS; ray++) {
                double angle = part.fieldOfView() * ((double) ray / (RAYS - 1) - 0.5);
                nearest = Math.min(nearest, rays.range(mapFromSonar.compose(new Pose2d(0, 0, angle))));
            }
            ranges[i] = Fakes.asMeasured(nearest, part.rangeMin(), part.rangeMax());
        }
        return ranges;
    }
}
