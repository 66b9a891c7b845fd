package rsal.player.bridge;

import java.util.ArrayList;
import java.util.List;
import rsal.data.BumperState;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.player.message.BumperInterface;
import rsal.player.message.Interface;
import rsal.player.message.Pose3;
import rsal.player.wire.MessageKind;
import rsal.robot.RobotModel.Part;
import rsal.time.Scheduler;

/// Bumpers as `bumper`.
final class OfferedBumpers extends OfferedSensor<BumperState> {
    private final List<Part.Bumper.Pad> pads;

    /// @param pads what it has, as far as that is known
    OfferedBumpers(int index, rsal.device.Bumper bumpers, List<Part.Bumper.Pad> pads, Scheduler scheduler) {
        super(Interface.BUMPER, index, bumpers, scheduler);
        this.pads = List.copyOf(pads);
    }

    @Override
    void publish(Stamped<BumperState> reading) {
        List<Boolean> pressed = reading.value().pressed();
        var bytes = new byte[pressed.size()];
        for (int i = 0; i < bytes.length; i++) {
            bytes[i] = (byte) (pressed.get(i) ? 1 : 0);
        }
        publish(BumperInterface.STATE, reading.time(), new BumperInterface.State(bytes));
    }

    @Override
    public boolean understands(MessageKind kind, int subtype) {
        return kind == MessageKind.REQUEST && subtype == BumperInterface.GEOMETRY;
    }

    @Override
    Record body(BumperState newest, int subtype) {
        List<Pose2d> poses = newest.baseFromBumpers();
        var segments = new ArrayList<BumperInterface.Segment>();
        for (int i = 0; i < poses.size(); i++) {
            double length = poses.size() == pads.size() ? pads.get(i).length() : 0;
            segments.add(new BumperInterface.Segment(Pose3.of(poses.get(i)), (float) length, 0));
        }
        return new BumperInterface.Geometry(segments);
    }
}
