package rsal.environment;

import java.util.List;
import java.util.Optional;
import rsal.data.Twist2d;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Velocities of a base: forward [m/s] and turn [rad/s].
public final class VelocityAction implements ActionType {
    private static final Parameter<Double> BACKWARD =
            Parameter.number("backward", 0, 0, 10, "m/s", "Greatest speed backward.");
    private static final Parameter<Double> FORWARD =
            Parameter.number("forward", 0.5, 0, 10, "m/s", "Greatest speed forward.");
    private static final Parameter<Double> TURN =
            Parameter.number("turn", 1.5, 0, 20, "rad/s", "Greatest angular velocity in both directions.");

    @Override
    public String key() {
        return "velocity";
    }

    @Override
    public String description() {
        return "Drives at a velocity: forward [m/s] and turn [rad/s].";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(BACKWARD, FORWARD, TURN);
    }

    @Override
    public Optional<String> refusal(Arguments arguments) {
        return arguments.get(BACKWARD) + arguments.get(FORWARD) > 0
                ? Optional.empty()
                : Optional.of("'forward' or 'backward' must be more than 0.");
    }

    @Override
    public LearnerAction create(Arguments arguments) {
        refusal(arguments).ifPresent(why -> {
            throw new IllegalArgumentException(why);
        });
        return new Velocity(
                arguments.get(BACKWARD).floatValue(),
                arguments.get(FORWARD).floatValue(),
                arguments.get(TURN).floatValue());
    }

    private record Velocity(float backward, float forward, float turn) implements LearnerAction {
        @Override
        public List<String> fields() {
            return List.of("forward [m/s]", "turn [rad/s]");
        }

        @Override
        public float[] low() {
            return new float[] {-backward, -turn};
        }

        @Override
        public float[] high() {
            return new float[] {forward, turn};
        }

        @Override
        public Actor of(Learner learner) {
            return (from, at) -> learner.drive(Twist2d.drive(from[at], from[at + 1]));
        }
    }
}
