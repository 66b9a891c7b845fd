package rsal.navigation.device;

import java.util.List;
import rsal.data.Pose2d;
import rsal.device.Navigator.Tolerance;
import rsal.navigation.control.GoalChecker;
import rsal.navigation.control.GoalCheckerType;
import rsal.navigation.control.ProgressChecker;
import rsal.navigation.control.ProgressCheckerType;
import rsal.navigation.recovery.RecoveryType;
import rsal.settings.PluginChoice;

/// The plugins of which a navigator needs new ones for each goal.
///
/// @param recoveries for when the robot makes no progress, in their order
/// @param lostRecovery for when it does not know where it is
/// @param driven by recoveries
record TaskPlugins(
        PluginChoice goalChecker,
        PluginChoice progressChecker,
        List<PluginChoice> recoveries,
        PluginChoice lostRecovery,
        RecoveryType.Driven driven) {

    GoalChecker newGoalChecker(Pose2d mapFromGoal, Tolerance tolerance) {
        return goalChecker.as(GoalCheckerType.class).create(goalChecker.arguments(), mapFromGoal, tolerance);
    }

    ProgressChecker newProgressChecker() {
        return progressChecker.as(ProgressCheckerType.class).create(progressChecker.arguments());
    }

    RecoveryList newRecoveries() {
        return list(recoveries);
    }

    RecoveryList newLostRecovery() {
        return list(List.of(lostRecovery));
    }

    private RecoveryList list(List<PluginChoice> chosen) {
        return new RecoveryList(chosen.stream()
                .map(choice -> new RecoveryList.Named(
                        choice.toString(), choice.as(RecoveryType.class).create(choice.arguments(), driven)))
                .toList());
    }
}
