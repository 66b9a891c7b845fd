package rsal.sim;

import java.util.random.RandomGenerator;
import org.jspecify.annotations.Nullable;
import rsal.data.Pose2d;
import rsal.sim.device.SimulatedRobot;
import rsal.sim.world.Body;
import rsal.sim.world.CameraRays;
import rsal.sim.world.World;

/// A robot as a device of a registered kind may know it.
final class TrueRobot implements SimulatedRobot {
    private final World world;
    private final Body body;
    private final DeviceMount mount;
    private final Pose2d baseFromDevice; // while the actuators that it stands on are at home
    private final double height;
    private final RandomGenerator random;
    private final double noise;
    private @Nullable CameraRays view; // of its last image

    /// @param height of the device above the base [m]
    TrueRobot(
            World world,
            Body body,
            DeviceMount mount,
            Pose2d baseFromDevice,
            double height,
            RandomGenerator random,
            double noise) {
        this.world = world;
        this.body = body;
        this.mount = mount;
        this.baseFromDevice = baseFromDevice;
        this.height = height;
        this.random = random;
        this.noise = noise;
    }

    @Override
    public Pose2d mapFromDevice() {
        return body.pose().compose(mount.now().moved(baseFromDevice));
    }

    @Override
    public double height() {
        return body.height() + height + mount.now().rise();
    }

    @Override
    public void paint(int columns, int rows, double focalLength, double reach, int[] colors, float[] depths) {
        var pinhole = new CameraRays.Pinhole(columns, rows, focalLength);
        CameraRays known = view;
        if (known == null || !known.isOf(pinhole)) {
            known = new CameraRays(baseFromDevice, pinhole, height);
            view = known;
        }
        known.paint(world, body, mount.seen(), reach, colors, depths);
    }

    @Override
    public RandomGenerator random() {
        return random;
    }

    @Override
    public double noise() {
        return noise;
    }
}
