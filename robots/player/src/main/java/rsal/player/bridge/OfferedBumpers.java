package rsal.player.bridge;

import java.util.List;
import java.util.Optional;
import rsal.data.BumperState;
import rsal.data.Stamped;
import rsal.device.Subscription;
import rsal.player.message.Bumper;
import rsal.player.message.Interface;
import rsal.player.wire.Kind;
import rsal.player.wire.Packet;
import rsal.time.Scheduler;

/// Bumpers as `bumper`.
final class OfferedBumpers extends Offered {
    private final rsal.device.Bumper bumpers;

    OfferedBumpers(int index, rsal.device.Bumper bumpers, Scheduler scheduler) {
        super(Interface.BUMPER, index, bumpers.info(), scheduler);
        this.bumpers = bumpers;
    }

    @Override
    Subscription listen() {
        return bumpers.subscribe(this::tell);
    }

    private void tell(Stamped<BumperState> reading) {
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
    Optional<Answer> answer(Packet request) {
        return bumpers.latest()
                .filter(_ -> understands(Kind.REQUEST, request.header().subtype()))
                .map(reading -> new Answer.Told(new Bumper.Geometry(reading.value().baseFromBumpers().stream()
                        .map(pose -> new Bumper.Segment(pose3(pose), 0, 0))
                        .toList())));
    }
}
