package rsal.engine.report;

import java.util.List;
import rsal.robot.RobotModel;

/// What a robot can be told to do.
///
/// @param drive what its base can do
/// @param behaviors as [rsal.engine.RunOperator#behave] takes them
/// @param noBehavior why it can be given none that needs sensors, in a sentence; empty when it can
/// @param noGoal why it can't be sent anywhere, in a sentence; empty when it can
public record Abilities(RobotModel.Drive drive, List<String> behaviors, String noBehavior, String noGoal) {
    public Abilities {
        behaviors = List.copyOf(behaviors);
    }
}
