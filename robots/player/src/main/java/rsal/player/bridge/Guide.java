package rsal.player.bridge;

import org.jspecify.annotations.Nullable;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.device.DriveBase;
import rsal.device.GoalHandle;
import rsal.device.Localizer;
import rsal.device.Navigator;
import rsal.device.Navigator.Progress;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;

/// Takes a base to goals of its odometry around what is in the way, as Player's `vfh`, `nd` and `snd` do: by a
/// navigator.
final class Guide {
    private final DriveBase base;
    private final Navigator navigator;
    private final Localizer localizer;
    private final Tolerance tolerance;
    private @Nullable Pose2d wanted; // in the frame of odometry
    private @Nullable GoalHandle<Progress, Result> drive; // there

    Guide(DriveBase base, Navigator navigator, Localizer localizer, Tolerance tolerance) {
        this.base = base;
        this.navigator = navigator;
        this.localizer = localizer;
        this.tolerance = tolerance;
    }

    /// Goes there, as soon as it is known where the robot is; goes on when it does so already.
    void goTo(Pose2d odomFromGoal) {
        if (!odomFromGoal.equals(wanted)) {
            wanted = odomFromGoal;
            drive = null; // the navigator goes on from that one
            begin();
        }
    }

    /// Begins what has not begun.
    void begin() {
        var odometry = base.latest().map(Stamped::value);
        var estimate = localizer.latest().map(Stamped::value);
        if (wanted == null || drive != null || odometry.isEmpty() || estimate.isEmpty()) {
            return;
        }
        Pose2d baseFromGoal = odometry.get().odomFromBase().inverse().compose(wanted);
        Pose2d mapFromGoal = estimate.get().mapFromBase().compose(baseFromGoal);
        if (!mapFromGoal.isFinite()) { // farther away than numbers reach
            wanted = null;
            return;
        }
        var going = navigator.goTo(mapFromGoal, tolerance);
        drive = going;
        going.result().thenAccept(_ -> {
            if (going.equals(drive)) {
                drive = null;
                wanted = null;
            }
        });
    }

    void letGo() {
        GoalHandle<Progress, Result> last = drive;
        drive = null;
        wanted = null;
        if (last != null) {
            last.cancel();
        }
    }
}
