package rsal.testkit.fake;

import java.time.InstantSource;
import org.jspecify.annotations.Nullable;
import rsal.data.LaserScan;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.device.DeviceInfo;
import rsal.device.LaserScanner;
import rsal.robot.RobotModel.Part;
import rsal.testkit.ObviousRays;

/// A laser that sees walls exactly, or what a test shows it.
public final class FakeLaserScanner extends FakeSensor<LaserScan> implements LaserScanner {
    private final Part.Laser part;
    private final FakeDriveBase base;
    private final ObviousRays rays;
    private final InstantSource clock;
    private float @Nullable [] shown;

    FakeLaserScanner(DeviceInfo info, Part.Laser part, FakeDriveBase base, ObviousRays rays, InstantSource clock) {
        super(info);
        this.part = part;
        this.base = base;
        this.rays = rays;
        this.clock = clock;
    }

    /// From now on every scan holds these ranges [m].
    public void show(float... ranges) {
        shown = ranges.clone();
    }

    @Override
    void sense() {
        float[] ranges = shown != null ? shown : look();
        deliver(new Stamped<>(
                clock.instant(),
                info().id(),
                new LaserScan(
                        part.baseFromLaser(),
                        part.angleMin(),
                        part.angleIncrement(),
                        part.rangeMin(),
                        part.rangeMax(),
                        ranges)));
    }

    private float[] look() {
        Pose2d mapFromLaser = base.mapFromBase().compose(part.baseFromLaser());
        var ranges = new float[part.samples()];
        for (int beam = 0; beam < ranges.length; beam++) {
            Pose2d direction = new Pose2d(0, 0, part.angleMin() + beam * part.angleIncrement());
            ranges[beam] =
                    Fakes.asMeasured(rays.range(mapFromLaser.compose(direction)), part.rangeMin(), part.rangeMax());
        }
        return ranges;
    }
}
