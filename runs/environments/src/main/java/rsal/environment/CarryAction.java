package rsal.environment;

import java.util.List;
import rsal.data.Twist2d;
import rsal.device.Gripper;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Velocities of a base, and whether its gripper lets go. The gripper is to close by itself (`snatches`).
public final class CarryAction implements ActionType {
    private static final float RELEASES = 0.5F; // from this number on
    private static final Parameter<Double> BACKWARD =
            Parameter.number("backward", 0.2, 0, 10, "m/s", "Greatest speed backward.");
    private static final Parameter<Double> FORWARD =
            Parameter.number("forward", 0.5, 0.01, 10, "m/s", "Greatest speed forward.");
    private static final Parameter<Double> TURN =
            Parameter.number("turn", 1.5, 0, 20, "rad/s", "Greatest angular velocity in both directions.");

    @Override
    public String key() {
        return "carry";
    }

    @Override
    public String description() {
        return "Drives at a velocity, and opens the gripper if the third number is at least 0.5 and it holds something.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(BACKWARD, FORWARD, TURN);
    }

    @Override
    public LearnerAction create(Arguments arguments) {
        return new Carry(
                arguments.get(BACKWARD).floatValue(),
                arguments.get(FORWARD).floatValue(),
                arguments.get(TURN).floatValue());
    }

    private record Carry(float backward, float forward, float turn) implements LearnerAction {
        @Override
        public List<String> fields() {
            return List.of("forward [m/s]", "turn [rad/s]", "release");
        }

        @Override
        public float[] low() {
            return new float[] {-backward, -turn, 0};
        }

        @Override
        public float[] high() {
            return new float[] {forward, turn, 1};
        }

        @Override
        public Actor of(Learner learner) {
            Gripper gripper = learner.robot()
                    .find(Gripper.class)
                    .orElseThrow(() -> new IllegalArgumentException("Robot '%s' has no gripper for the action 'carry'."
                            .formatted(learner.robot().id())));
            return (from, at) -> {
                learner.drive(Twist2d.drive(from[at], from[at + 1]));
                if (from[at + 2] >= RELEASES) {
                    learner.run(() -> gripper.latest()
                            .filter(newest -> newest.value().holding())
                            .ifPresent(_ -> gripper.open()));
                }
            };
        }
    }
}
