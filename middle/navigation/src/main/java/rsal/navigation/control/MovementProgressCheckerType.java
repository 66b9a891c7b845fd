package rsal.navigation.control;

import java.util.List;
import org.jspecify.annotations.Nullable;
import rsal.data.Angles;
import rsal.data.Pose2d;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Progress is a move, wherever it leads, as Nav2's SimpleProgressChecker and PoseProgressChecker have it.
public final class MovementProgressCheckerType implements ProgressCheckerType {
    private static final Parameter<Double> DISTANCE = Parameter.number(
            "distance",
            0.5,
            0.01,
            10,
            "m",
            "the robot makes progress when it is this far from the place of its last progress");
    private static final Parameter<Double> ANGLE = Parameter.number(
            "angle", 60, 1, 180, "deg", "the robot also makes progress when it has rotated by" + " more than this");

    @Override
    public String key() {
        return "movement";
    }

    @Override
    public String description() {
        return "A robot makes progress when it moves or turns, in any direction.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(DISTANCE, ANGLE);
    }

    @Override
    public ProgressChecker create(Arguments arguments) {
        double distance = arguments.get(DISTANCE);
        double angle = arguments.radians(ANGLE);
        return new ProgressChecker() {
            private @Nullable Pose2d mapFromLast;

            @Override
            public boolean isProgress(Pose2d mapFromBase, double left) {
                Pose2d last = mapFromLast;
                if (last != null
                        && mapFromBase.distanceTo(last) <= distance
                        && Math.abs(Angles.difference(last.theta(), mapFromBase.theta())) <= angle) {
                    return false;
                }
                mapFromLast = mapFromBase;
                return true;
            }

            @Override
            public void onNewPath(double left) {} // moves count whatever the path
        };
    }
}
