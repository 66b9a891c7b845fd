package rsal.player.device;

import java.time.Instant;
import java.util.List;
import rsal.data.GripperState.Lift;
import rsal.data.Interval;
import rsal.player.message.Actarray;
import rsal.player.wire.Address;

/// The lift of a gripper, which is the first joint of an `actarray`.
final class PlayerLift extends Limb {
    private static final double NEAR = 0.1; // of its way

    private final RemoteServer server;
    private Interval limits = new Interval(0, 1);
    private double raised;
    private boolean moves;

    PlayerLift(Address address, RemoteServer server) {
        super(address);
        this.server = server;
    }

    @Override
    public List<Integer> questions() {
        return List.of(Actarray.GEOMETRY);
    }

    @Override
    public void answered(Record body) {
        limits = Joints.limits(body).orElse(limits);
    }

    @Override
    public void take(Instant time, Record body) {
        Joints.first(body).ifPresent(joint -> {
            raised = Math.clamp((joint.position() - limits.least()) / (limits.most() - limits.least()), 0, 1);
            moves = joint.state() == Actarray.MOVING;
            changed(time);
        });
    }

    /// From 0, down, to 1.
    double raised() {
        return raised;
    }

    /// @param wanted 1 when it is to go up, -1 when down, 0 when it is to do nothing
    Lift state(int wanted) {
        boolean up = !moves && raised > 1 - NEAR;
        boolean down = !moves && raised < NEAR;
        return switch (wanted) {
            case 1 -> up ? Lift.UP : Lift.RISING;
            case -1 -> down ? Lift.DOWN : Lift.SINKING;
            default -> up ? Lift.UP : down ? Lift.DOWN : Lift.STOPPED;
        };
    }

    /// @param place 0 for down, 1 for up
    void goTo(int place) {
        var position = new Actarray.Position(0, (float) (place == 1 ? limits.most() : limits.least()));
        server.command(address(), Actarray.POSITION, position);
    }

    void stop() {
        server.command(address(), Actarray.SPEED, new Actarray.Speed(0, 0));
    }
}
