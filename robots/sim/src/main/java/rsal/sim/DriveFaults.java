package rsal.sim;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import rsal.data.Twist2d;
import rsal.device.Subscription;
import rsal.fault.Fault;

/// What is wrong with a drive now, besides what its odometry shows. Several at once: powers multiply, slips add up.
final class DriveFaults {
    private final List<Fault> active = new ArrayList<>();
    private double power = 1;
    private Fault.Slip slip = new Fault.Slip(0, 0, 0);

    /// @return ends it
    Subscription add(Fault fault) {
        active.add(fault);
        update();
        return () -> {
            active.remove(fault); // which of equal ones does not matter
            update();
        };
    }

    private void update() {
        power = of(Fault.MotorDead.class).stream()
                .mapToDouble(Fault.MotorDead::power)
                .reduce(1, (one, other) -> one * other);
        List<Fault.Slip> slips = of(Fault.Slip.class);
        slip = new Fault.Slip(sum(slips, Fault.Slip::way), sum(slips, Fault.Slip::turn), sum(slips, Fault.Slip::drift));
    }

    private <F extends Fault> List<F> of(Class<F> kind) {
        return active.stream().filter(kind::isInstance).map(kind::cast).toList();
    }

    private static double sum(List<Fault.Slip> slips, ToDoubleFunction<Fault.Slip> of) {
        return slips.stream().mapToDouble(of).sum();
    }

    /// Whether the motors do nothing at all.
    boolean dead() {
        return power == 0;
    }

    /// What the motors make of a command.
    Twist2d obeyed(Twist2d command) {
        return power == 1 ? command : new Twist2d(command.vx() * power, command.vy() * power, command.omega() * power);
    }

    /// What the wheels turn while the robot moves: a way and a turn, or the speeds of both.
    Twist2d counted(Twist2d made) {
        return active.isEmpty()
                ? made
                : new Twist2d(
                        made.vx() * (1 + slip.way()),
                        made.vy() * (1 + slip.way()),
                        made.omega() * (1 + slip.turn()) + slip.drift() * made.vx());
    }
}
