package rsal.player.bridge;

import java.util.List;
import rsal.data.BumperState;
import rsal.data.Stamped;
import rsal.player.message.Bumper;
import rsal.player.message.Interface;
import rsal.player.message.Pose3;
import rsal.player.wire.Kind;
import rsal.time.Scheduler;

/// Bumpers as `bumper`.
final class OfferedBumpers extends OfferedSensor<BumperState> {
    OfferedBumpers(int index, rsal.device.Bumper bumpers, Scheduler scheduler) {
        super(Interface.BUMPER, index, bumpers, scheduler);
    }

    @Override
    void tell(Stamped<BumperState> reading) {
        List<Boolean> pressed = reading.value().pressed();
        var bytes = new byte[pressed.size()];
        for (int i = 0; i < bytes.length; i++) {
            bytes[i] = (byte) (pressed.get(i) ? 1 : 0);
        }
        publish(Bumper.STATE, reading.time(), new Bumper.State(bytes));
    }

    @Override
    public boolean understands(Kind kind, int subtype) {
        return kind == Kind.REQUEST && subtype == Bumper.GEOMETRY;
    }

    @Override
    Record body(BumperState newest, int subtype) {
        return new Bumper.Geometry(newest.baseFromBumpers().stream()
                .map(pose -> new Bumper.Segment(Pose3.of(pose), 0, 0))
                .toList());
    }
}
