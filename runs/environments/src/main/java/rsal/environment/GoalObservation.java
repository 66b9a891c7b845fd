package rsal.environment;

import java.util.List;
import rsal.agent.AgentContext;
import rsal.device.Navigator;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// What became of the newest goal that the learner has sent its navigator to, by the actions `goal` and `place`. Real
/// robots have it.
public final class GoalObservation implements ObservationType {
    private static final List<Learner.GoalState> STATES = List.of(
            Learner.GoalState.UNDER_WAY,
            Learner.GoalState.REACHED,
            Learner.GoalState.NO_PATH,
            Learner.GoalState.GIVEN_UP);

    @Override
    public String key() {
        return "goal";
    }

    @Override
    public String description() {
        return "Whether the newest goal of the navigator is under way, is reached, has no path, or was given up.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of();
    }

    @Override
    public LearnerObservation create(Arguments arguments) {
        return new Goal();
    }

    private record Goal() implements LearnerObservation {
        @Override
        public List<String> fields() {
            return List.of("goal is under way", "goal is reached", "goal has no path", "goal was given up");
        }

        @Override
        public float[] low() {
            return new float[STATES.size()];
        }

        @Override
        public float[] high() {
            return new float[] {1, 1, 1, 1};
        }

        @Override
        public Maker listen(Learner learner, AgentContext self) {
            return (robot, world) -> {
                if (robot.find(Navigator.class).isEmpty()) {
                    throw new IllegalArgumentException(
                            "Robot '%s' has no navigator for the observation 'goal'.".formatted(robot.id()));
                }
                return (to, at) -> {
                    for (int i = 0; i < STATES.size(); i++) {
                        to[at + i] = learner.goal() == STATES.get(i) ? 1 : 0;
                    }
                };
            };
        }

        @Override
        public Reader of(Robot robot, Truth world) {
            throw new IllegalStateException("Goals are known by learners only.");
        }
    }
}
