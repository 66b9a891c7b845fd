package rsal.player.bridge;

import java.util.Optional;
import rsal.data.Pose2d;
import rsal.device.SimulationControl;
import rsal.device.SimulationControl.Placement;
import rsal.device.Subscription;
import rsal.player.message.Chars;
import rsal.player.message.Interface;
import rsal.player.message.Pose;
import rsal.player.message.Pose3;
import rsal.player.message.Simulation;
import rsal.player.wire.MalformedException;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;
import rsal.time.Scheduler;

/// The truth of a simulated world as `simulation`: where robots and things are, and where they are put.
final class OfferedSimulation extends Offered {
    private static final double MICROSECONDS = 1e6; // as Stage tells its time

    private final SimulationControl simulation;

    OfferedSimulation(int index, SimulationControl simulation, Scheduler scheduler) {
        super(Interface.SIMULATION, index, simulation.info(), scheduler);
        this.simulation = simulation;
    }

    @Override
    Subscription listen() {
        return () -> {};
    }

    @Override
    public boolean understands(MessageKind kind, int subtype) {
        return kind == MessageKind.REQUEST && subtype >= Simulation.POSE && subtype <= Simulation.SET_POSE3;
    }

    @Override
    Optional<Answer> answer(Packet request) throws MalformedException {
        return switch (request.header().subtype()) {
            case Simulation.POSE -> {
                String name = Chars.text(request.body(Simulation.Placed.class).name());
                yield simulation
                        .truth(name)
                        .map(pose -> new Answer.Reported(new Simulation.Placed(Chars.of(name), Pose.of(pose))));
            }
            case Simulation.POSE3 -> {
                String name = Chars.text(request.body(Simulation.Placed3.class).name());
                double time = MICROSECONDS * seconds(scheduler().instant());
                yield simulation
                        .truth(name)
                        .map(pose -> new Answer.Reported(new Simulation.Placed3(Chars.of(name), Pose3.of(pose), time)));
            }
            case Simulation.SET_POSE -> {
                var wanted = request.body(Simulation.Placed.class);
                yield place(wanted.name(), wanted.pose().to2d());
            }
            case Simulation.SET_POSE3 -> {
                var wanted = request.body(Simulation.Placed3.class);
                yield place(wanted.name(), wanted.pose().to2d());
            }
            default -> Optional.empty();
        };
    }

    private Optional<Answer> place(byte[] name, Pose2d mapFromEntity) {
        return simulation.place(Chars.text(name), mapFromEntity) instanceof Placement.Placed
                ? Optional.of(new Answer.Done())
                : Optional.empty();
    }
}
