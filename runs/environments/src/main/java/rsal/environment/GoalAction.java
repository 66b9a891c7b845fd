package rsal.environment;

import java.util.List;
import rsal.data.Pose2d;
import rsal.device.Localizer;
import rsal.device.Navigator;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// A goal for the robot's navigator, relative to where its localizer believes it to be.
public final class GoalAction implements ActionType {
    private static final Parameter<Double> REACH =
            Parameter.number("reach", 3, 0.1, 100, "m", "Greatest distance of a goal along each axis.");
    private static final double NEAR = 0.3; // m, at which a goal counts as reached

    @Override
    public String key() {
        return "goal";
    }

    @Override
    public String description() {
        return "Sends the navigator to a position in the base frame [m].";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(REACH);
    }

    @Override
    public LearnerAction create(Arguments arguments) {
        return new Goal(arguments.get(REACH).floatValue());
    }

    private record Goal(float reach) implements LearnerAction {
        @Override
        public List<String> fields() {
            return List.of("x of goal [m]", "y of goal [m]");
        }

        @Override
        public float[] low() {
            return new float[] {-reach, -reach};
        }

        @Override
        public float[] high() {
            return new float[] {reach, reach};
        }

        @Override
        public Actor of(Learner learner) {
            Robot robot = learner.robot();
            Navigator navigator = robot.find(Navigator.class)
                    .orElseThrow(() -> new IllegalArgumentException(
                            "Robot '%s' has no navigator for the action 'goal'.".formatted(robot.id())));
            Localizer localizer = robot.require(Localizer.class);
            return (from, at) -> {
                float x = from[at];
                float y = from[at + 1];
                learner.run(() -> localizer.latest().ifPresent(believed -> {
                    Pose2d mapFromGoal = believed.value().mapFromBase().compose(new Pose2d(x, y, Math.atan2(y, x)));
                    learner.goTo(navigator, mapFromGoal, Navigator.Tolerance.position(NEAR));
                }));
            };
        }
    }
}
