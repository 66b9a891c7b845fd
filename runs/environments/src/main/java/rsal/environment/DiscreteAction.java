package rsal.environment;

import java.util.List;
import rsal.data.Twist2d;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// One of five velocities: 0 stands, 1 drives forward, 2 turns left, 3 turns right, 4 drives backward.
public final class DiscreteAction implements ActionType {
    private static final Parameter<Double> SPEED =
            Parameter.number("speed", 0.4, 0.01, 10, "m/s", "Speed forward and backward.");
    private static final Parameter<Double> TURN =
            Parameter.number("turn", 1, 0.01, 20, "rad/s", "Angular velocity of turns.");

    @Override
    public String key() {
        return "discrete";
    }

    @Override
    public String description() {
        return "Stands (0), drives forward (1), turns left (2) or right (3), or drives backward (4).";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(SPEED, TURN);
    }

    @Override
    public LearnerAction create(Arguments arguments) {
        double speed = arguments.get(SPEED);
        double turn = arguments.get(TURN);
        return new Discrete(List.of(
                Twist2d.STOP,
                Twist2d.drive(speed, 0),
                Twist2d.drive(0, turn),
                Twist2d.drive(0, -turn),
                Twist2d.drive(-speed, 0)));
    }

    private record Discrete(List<Twist2d> velocities) implements LearnerAction {
        @Override
        public List<String> fields() {
            return List.of("choice");
        }

        @Override
        public float[] low() {
            return new float[] {0};
        }

        @Override
        public float[] high() {
            return new float[] {velocities.size() - 1};
        }

        @Override
        public int choices() {
            return velocities.size();
        }

        @Override
        public Actor of(Learner learner) {
            return (from, at) -> learner.drive(velocities.get(Math.round(from[at])));
        }
    }
}
