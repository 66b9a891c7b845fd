package rsal.player.bridge;

import java.util.List;
import java.util.Optional;
import rsal.data.GripperState;
import rsal.data.GripperState.Lift;
import rsal.data.Stamped;
import rsal.player.message.Actarray;
import rsal.player.message.Interface;
import rsal.player.message.Orientation;
import rsal.player.message.Point3;
import rsal.player.wire.MalformedException;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;
import rsal.time.Scheduler;

/// The lift of a gripper as `actarray` of one joint, from 0 (down) to 1 (up), as Player's Pioneers have it. It
/// has no stops in between: to any place in its upper half it goes up.
final class OfferedLift extends OfferedSensor<GripperState> {
    private static final int LINEAR = 1;

    private final GripperCommands commands;

    OfferedLift(int index, rsal.device.Gripper gripper, GripperCommands commands, Scheduler scheduler) {
        super(Interface.ACTARRAY, index, gripper, scheduler);
        this.commands = commands;
    }

    @Override
    void publish(Stamped<GripperState> reading) {
        GripperState state = reading.value();
        boolean moving = state.lift() == Lift.RISING || state.lift() == Lift.SINKING;
        float raised = Double.isNaN(state.raised()) ? 0.5f : (float) state.raised();
        var joint = new Actarray.Joint(raised, 0, 0, 0, moving ? Actarray.MOVING : Actarray.IDLE);
        publish(Actarray.STATE, reading.time(), new Actarray.State(List.of(joint), 1));
    }

    @Override
    public boolean understands(MessageKind kind, int subtype) {
        return OfferedActuator.Order.isOne(kind, subtype)
                || (kind == MessageKind.REQUEST && subtype == Actarray.GEOMETRY);
    }

    @Override
    Record body(GripperState newest, int subtype) {
        var nowhere = new Orientation(0, 0, 0);
        return new Actarray.Geometry(
                List.of(new Actarray.JointGeometry(LINEAR, 1, nowhere, new Point3(0, 0, 1), 0, 0.5f, 1, 0, 0, 0)),
                new Point3(0, 0, 0),
                nowhere);
    }

    @Override
    void obey(Packet command) throws MalformedException {
        Optional<OfferedActuator.Order> order = OfferedActuator.Order.of(command);
        if (order.isPresent()) {
            switch (order.get()) {
                case OfferedActuator.Order.Position(double position) when position > 0.5 -> commands.lift();
                case OfferedActuator.Order.Position(double position) when position <= 0.5 -> commands.lower();
                case OfferedActuator.Order.Speed(double speed) when speed > 0 -> commands.lift();
                case OfferedActuator.Order.Speed(double speed) when speed < 0 -> commands.lower();
                case OfferedActuator.Order.Speed(double speed) when speed == 0 -> commands.stopLift();
                case OfferedActuator.Order.Home _ -> commands.lower();
                default -> {} // no number
            }
        }
    }
}
