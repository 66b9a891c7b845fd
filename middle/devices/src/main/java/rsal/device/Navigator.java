package rsal.device;

import java.time.Duration;
import java.util.Locale;
import java.util.Optional;
import rsal.data.OccupancyGrid;
import rsal.data.Path2d;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;

/// Drives the robot to goals on the map.
public interface Navigator extends Device, Locomotion {
    /// Drives to a goal. A new goal cancels the one under way; when it is near the old one the robot does not
    /// stop in between.
    ///
    /// @throws IllegalArgumentException when the pose is not finite
    GoalHandle<Progress, Result> goTo(Pose2d mapFromGoal, Tolerance tolerance);

    default GoalHandle<Progress, Result> goTo(Pose2d mapFromGoal) {
        return goTo(mapFromGoal, Tolerance.DEFAULT);
    }

    /// Stands still and keeps the goal.
    void pause();

    void resume();

    boolean paused();

    /// The present goal.
    Optional<Pose2d> goal();

    /// The planned path from here; empty without a goal.
    Path2d path();

    /// The path of the next one or two seconds, around the obstacles that it sees: the last prediction of its
    /// controller. It is in the map frame, begins at the estimated pose, and has at most 16 points. Empty
    /// without a goal, while the robot stands or turns in place, and if the controller does not report one.
    default Path2d localPath() {
        return Path2d.EMPTY;
    }

    /// The cost map, with values as in `nav_msgs/OccupancyGrid`: [OccupancyGrid#FREE] far from obstacles, up to
    /// 99 at the highest cost, [OccupancyGrid#OCCUPIED] where the robot's center can't be, and
    /// [OccupancyGrid#UNKNOWN] for unknown cells. Do not write to it. Empty if the navigator plans without a
    /// map, or does not report costs.
    default Optional<OccupancyGrid> costMap() {
        return Optional.empty();
    }

    /// When a goal counts as reached.
    ///
    /// @param angle how far the heading may be off [rad]; π or more when the heading does not matter
    record Tolerance(double distance, double angle) {
        public static final Tolerance DEFAULT = new Tolerance(0.4, Math.toRadians(10));

        /// Near enough, whichever way the robot looks.
        public static Tolerance position(double distance) {
            return new Tolerance(distance, Math.PI);
        }
    }

    /// How far a goal has got.
    ///
    /// @param mapFromBase where the robot is
    /// @param remaining length of way left [m]
    /// @param waypoint the point it heads for now
    /// @param driving since when, in run time, it works on this goal
    record Progress(Pose2d mapFromBase, double remaining, Point2d waypoint, Duration driving) {}

    /// The one way in which a goal ended.
    sealed interface Result {
        /// It stands where it takes the goal to be.
        ///
        /// @param doubt why it may be elsewhere: for people; empty when it is localized
        record Reached(Pose2d mapFromBase, String doubt) implements Result {
            /// By who knows where it is.
            public Reached(Pose2d mapFromBase) {
                this(mapFromBase, "");
            }

            /// As sure as an estimate is.
            public static Reached by(PoseEstimate estimate) {
                return new Reached(
                        estimate.mapFromBase(),
                        estimate.quality() == PoseEstimate.Quality.LOCALIZED
                                ? ""
                                : String.format(
                                        Locale.ROOT,
                                        "The robot takes itself to be there, but is not sure: %s, confidence %.2f.",
                                        estimate.quality().name().toLowerCase(Locale.ROOT),
                                        estimate.confidence()));
            }

            /// Whether the robot knew where it is.
            public boolean isSure() {
                return doubt.isEmpty();
            }
        }

        /// @param why who or what called it off: for people
        record Cancelled(String why) implements Result {
            /// By those that have the goal's handle.
            public static Cancelled asked() {
                return new Cancelled("The agent that set the goal canceled it.");
            }

            /// By a goal that came later.
            public static Cancelled by(Pose2d mapFromNext) {
                return new Cancelled(
                        String.format(Locale.ROOT, "A new goal came, (%.2f, %.2f).", mapFromNext.x(), mapFromNext.y()));
            }
        }

        /// No path leads there.
        ///
        /// @param why for people
        record NoPath(String why) implements Result {}

        /// It got no nearer for too long, or nobody knew for too long where it is.
        ///
        /// @param mapFromBase where, as known last; the map's origin when it was never known, which `why` tells
        /// @param tried since when it worked on this goal
        /// @param why what it tried, what is left, what is near: for people
        record Stuck(Pose2d mapFromBase, Duration tried, String why) implements Result {}
    }
}
