package rsal.sim;

import java.time.Instant;
import java.util.List;
import rsal.data.BumperState;
import rsal.data.Pose2d;
import rsal.device.Bumper;
import rsal.device.DeviceInfo;
import rsal.robot.RobotModel.Part;
import rsal.robot.Shift;
import rsal.sim.world.Body;
import rsal.sim.world.BumperGeometry;
import rsal.sim.world.World;

/// Simulated bumpers. Each feels what is in the robot's way up to 1 cm outside of it, at its own height.
final class SimBumper extends SimActuatedDevice<BumperState> implements Bumper {
    private final World world;
    private final Body robot;
    private final List<Pose2d> baseFromPads;
    private final List<BumperGeometry> feelers;
    private final DeviceMount mount;

    /// @param height above the base [m]
    SimBumper(DeviceInfo info, Part.Bumper part, World world, Body robot, double height, DeviceMount mount) {
        super(info, info.robot() + "/base_link", part.period());
        this.world = world;
        this.robot = robot;
        this.mount = mount;
        this.baseFromPads =
                part.pads().stream().map(Part.Bumper.Pad::baseFromPad).toList();
        this.feelers = part.pads().stream()
                .map(pad -> new BumperGeometry(pad.baseFromPad(), pad.length(), height))
                .toList();
    }

    @Override
    void work(Instant now, double dt) {
        if (isDue(now)) {
            Shift shift = mount.now();
            List<Boolean> pressed = feelers.stream()
                    .map(feeler -> feeler.isPressed(world, robot, shift))
                    .toList();
            take(new BumperState(baseFromPads.stream().map(shift::moved).toList(), pressed), now);
        }
    }
}
