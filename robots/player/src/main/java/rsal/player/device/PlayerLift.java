package rsal.player.device;

import java.time.Instant;
import java.util.List;
import java.util.function.Consumer;
import rsal.data.GripperState.Lift;
import rsal.player.message.Actarray;
import rsal.player.wire.Address;

/// The lift of a gripper, which is the first joint of an `actarray`.
final class PlayerLift implements Remote {
    private static final double NEAR = 0.1; // of its way

    private final Address address;
    private final RemoteServer server;
    private Consumer<Instant> listener = _ -> {};
    private double bottom;
    private double top = 1;
    private double raised;
    private boolean moves;

    PlayerLift(Address address, RemoteServer server) {
        this.address = address;
        this.server = server;
    }

    void onChange(Consumer<Instant> told) {
        listener = told;
    }

    @Override
    public Address address() {
        return address;
    }

    @Override
    public List<Integer> questions() {
        return List.of(Actarray.GEOMETRY);
    }

    @Override
    public void answered(Record body) {
        if (body instanceof Actarray.Geometry geometry && !geometry.joints().isEmpty()) {
            Actarray.JointGeometry joint = geometry.joints().getFirst();
            if (joint.max() > joint.min()) {
                bottom = joint.min();
                top = joint.max();
            }
        }
    }

    @Override
    public void take(Instant time, Record body) {
        if (body instanceof Actarray.State state && !state.joints().isEmpty()) {
            Actarray.Joint joint = state.joints().getFirst();
            raised = Math.clamp((joint.position() - bottom) / (top - bottom), 0, 1);
            moves = joint.state() == Actarray.MOVING;
            listener.accept(time);
        }
    }

    @Override
    public void lost(String reason) {}

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
        var position = new Actarray.Position(0, (float) (place == 1 ? top : bottom));
        server.command(address, Actarray.POSITION, position);
    }

    void stop() {
        server.command(address, Actarray.SPEED, new Actarray.Speed(0, 0));
    }
}
