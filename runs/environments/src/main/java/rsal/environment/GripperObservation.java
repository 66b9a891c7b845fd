package rsal.environment;

import java.util.List;
import rsal.device.Gripper;
import rsal.robot.Robot;
import rsal.settings.Arguments;

/// Whether the gripper holds something. Real robots have it.
public final class GripperObservation implements ObservationType {
    @Override
    public String key() {
        return "gripper";
    }

    @Override
    public String description() {
        return "Whether the gripper holds something.";
    }

    @Override
    public LearnerObservation create(Arguments arguments) {
        return new Holding();
    }

    private record Holding() implements LearnerObservation {
        @Override
        public List<String> fields() {
            return List.of("holds something");
        }

        @Override
        public float[] low() {
            return new float[] {0};
        }

        @Override
        public float[] high() {
            return new float[] {1};
        }

        @Override
        public Reader of(Robot robot, Truth world) {
            Gripper gripper = robot.find(Gripper.class)
                    .orElseThrow(() -> new IllegalArgumentException(
                            "Robot '%s' has no gripper for the observation 'gripper'.".formatted(robot.id())));
            return (to, at) -> to[at] =
                    gripper.latest().filter(newest -> newest.value().holding()).isPresent() ? 1 : 0;
        }
    }
}
