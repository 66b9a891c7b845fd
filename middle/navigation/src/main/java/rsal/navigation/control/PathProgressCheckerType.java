package rsal.navigation.control;

import java.util.List;
import rsal.data.Pose2d;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Progress is less of the path that is left, or of the turn at the goal.
public final class PathProgressCheckerType implements ProgressCheckerType {
    private static final Parameter<Double> MIN_PROGRESS = Parameter.number(
            "minProgress",
            0.1,
            0.01,
            10,
            "m",
            "decrease of the remaining path that is progress; at the goal, of the remaining angle [rad]");

    @Override
    public String key() {
        return "path";
    }

    @Override
    public String description() {
        return "A robot makes progress when its remaining path gets shorter.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(MIN_PROGRESS);
    }

    @Override
    public ProgressChecker create(Arguments arguments) {
        double nearer = arguments.get(MIN_PROGRESS);
        return new ProgressChecker() {
            private double least = Double.POSITIVE_INFINITY;

            @Override
            public boolean isProgress(Pose2d mapFromBase, double left) {
                if (left >= least - nearer) {
                    return false;
                }
                least = left;
                return true;
            }

            @Override
            public void onNewPath(double left) {
                least = left;
            }
        };
    }
}
