package rsal.player.bridge;

import rsal.data.GripperState;
import rsal.data.Stamped;
import rsal.player.message.Dio;
import rsal.player.message.Interface;
import rsal.time.Scheduler;

/// The beams and contacts of a gripper as inputs of `dio`, on when something is there: the inner beam, the outer
/// one, the left contact, the right one.
final class OfferedBeams extends OfferedSensor<GripperState> {
    private static final int COUNT = 4;

    OfferedBeams(int index, rsal.device.Gripper gripper, Scheduler scheduler) {
        super(Interface.DIO, index, gripper, scheduler);
    }

    @Override
    void publish(Stamped<GripperState> reading) {
        GripperState state = reading.value();
        int bits = bit(0, state.innerBeamBroken())
                | bit(1, state.outerBeamBroken())
                | bit(2, state.leftContact())
                | bit(3, state.rightContact());
        publish(Dio.VALUES, reading.time(), new Dio.Values(COUNT, bits));
    }

    private static int bit(int number, boolean on) {
        return on ? 1 << number : 0;
    }
}
