package rsal.player.device;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rsal.data.BumperState;
import rsal.data.Pose2d;
import rsal.device.DeviceInfo;
import rsal.player.message.BumperInterface;
import rsal.player.wire.Address;
import rsal.robot.RobotModel.Part;

/// Bumpers behind `bumper`. Where they are is what the server says, else what the robot's model says.
final class PlayerBumpers extends PlayerSensor<BumperState> implements rsal.device.Bumper {
    private List<Pose2d> baseFromBumpers;

    PlayerBumpers(DeviceInfo info, Address address, Part.Bumper part) {
        super(info, address, info.robot() + "/base_link");
        this.baseFromBumpers =
                part.pads().stream().map(Part.Bumper.Pad::baseFromPad).toList();
    }

    @Override
    public List<Integer> questions() {
        return List.of(BumperInterface.GEOMETRY);
    }

    @Override
    public void answered(Record body) {
        if (body instanceof BumperInterface.Geometry geometry) {
            baseFromBumpers = geometry.bumpers().stream()
                    .map(bumper -> bumper.pose().to2d())
                    .toList();
        }
    }

    @Override
    Optional<BumperState> read(Record body) {
        if (!(body instanceof BumperInterface.State(byte[] bytes)) || bytes.length != baseFromBumpers.size()) {
            return Optional.empty();
        }
        var pressed = new ArrayList<Boolean>();
        for (byte each : bytes) {
            pressed.add(each != 0);
        }
        return Optional.of(new BumperState(baseFromBumpers, pressed));
    }
}
