package rsal.player.bridge;

import java.util.Optional;
import rsal.data.GripperState;
import rsal.data.GripperState.Paddles;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.player.message.Box3;
import rsal.player.message.GripperInterface;
import rsal.player.message.Interface;
import rsal.player.message.Pose3;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;
import rsal.robot.RobotModel.Part;
import rsal.time.Scheduler;

/// A gripper as `gripper`: its paddles, and STOP for these and the lift; STORE and RETRIEVE, which say nothing of
/// a lift, move that up and down.
final class OfferedGripper extends OfferedSensor<GripperState> {
    private static final int OPEN = 1;
    private static final int CLOSED = 2;
    private static final int MOVING = 3;
    private static final int INNER = 4; // bits of beams as Stage has them
    private static final int OUTER = 8;
    private static final int BEAMS = 2;

    private final GripperCommands commands;
    private final Optional<Part.Gripper> part;

    /// @param part what it is made like, if that is known
    OfferedGripper(
            int index,
            rsal.device.Gripper gripper,
            GripperCommands commands,
            Optional<Part.Gripper> part,
            Scheduler scheduler) {
        super(Interface.GRIPPER, index, gripper, scheduler);
        this.commands = commands;
        this.part = part;
    }

    @Override
    void publish(Stamped<GripperState> reading) {
        GripperState state = reading.value();
        int beams = (state.innerBeamBroken() ? INNER : 0) | (state.outerBeamBroken() ? OUTER : 0);
        publish(
                GripperInterface.STATE,
                reading.time(),
                new GripperInterface.State(code(state.paddles()), beams, state.holding() ? 1 : 0));
    }

    private static int code(Paddles paddles) {
        return switch (paddles) {
            case OPEN -> OPEN;
            case CLOSED -> CLOSED;
            case OPENING, CLOSING, STOPPED -> MOVING;
        };
    }

    @Override
    public boolean understands(MessageKind kind, int subtype) {
        return switch (kind) {
            case COMMAND -> subtype >= GripperInterface.OPEN && subtype <= GripperInterface.RETRIEVE;
            case REQUEST -> subtype == GripperInterface.GEOMETRY;
            default -> false;
        };
    }

    @Override
    void obey(Packet command) {
        switch (command.header().subtype()) {
            case GripperInterface.OPEN -> commands.open();
            case GripperInterface.CLOSE -> commands.close();
            case GripperInterface.STOP -> commands.stop();
            case GripperInterface.STORE -> commands.lift();
            case GripperInterface.RETRIEVE -> commands.lower();
            default -> {}
        }
    }

    @Override
    Record body(GripperState newest, int subtype) {
        return part.map(made -> new GripperInterface.Geometry(
                        Pose3.of(made.baseFromGripper()),
                        new Box3(made.width(), made.length(), made.height()),
                        new Box3(made.opening(), made.paddleLength(), made.height()),
                        BEAMS,
                        1))
                .orElseGet(() -> new GripperInterface.Geometry(Pose3.of(Pose2d.ORIGIN), NO_SIZE, NO_SIZE, BEAMS, 1));
    }
}
