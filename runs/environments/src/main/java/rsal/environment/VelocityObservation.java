package rsal.environment;

import java.util.List;
import rsal.data.Twist2d;
import rsal.device.DriveBase;
import rsal.robot.Robot;
import rsal.settings.Arguments;

/// The velocity that the wheels measure.
public final class VelocityObservation implements ObservationType {
    private static final float MAX = 10; // m/s, rad/s

    @Override
    public String key() {
        return "velocity";
    }

    @Override
    public String description() {
        return "Measured velocity of the base: forward and left [m/s], counter-clockwise [rad/s].";
    }

    @Override
    public LearnerObservation create(Arguments arguments) {
        return new Velocity();
    }

    private record Velocity() implements LearnerObservation {
        @Override
        public List<String> fields() {
            return List.of("forward [m/s]", "left [m/s]", "turn [rad/s]");
        }

        @Override
        public float[] low() {
            return new float[] {-MAX, -MAX, -MAX};
        }

        @Override
        public float[] high() {
            return new float[] {MAX, MAX, MAX};
        }

        @Override
        public Reader of(Robot robot, Truth world) {
            DriveBase base = robot.require(DriveBase.class);
            return (to, at) -> {
                Twist2d velocity =
                        base.latest().map(newest -> newest.value().velocity()).orElse(Twist2d.STOP);
                to[at] = Math.clamp((float) velocity.vx(), -MAX, MAX);
                to[at + 1] = Math.clamp((float) velocity.vy(), -MAX, MAX);
                to[at + 2] = Math.clamp((float) velocity.omega(), -MAX, MAX);
            };
        }
    }
}
