package rsal.agent.team;

import rsal.data.Pose2d;

/// Where a job leads a robot, or what is left of one under way: to its begin, from there to its end.
///
/// @param mapFromBegin where it must go first
/// @param mapFromEnd where it will be afterwards
/// @param work what else it costs, put as a length of way [m]: time that it stands times the speed it could drive
public record TaskRoute(Pose2d mapFromBegin, Pose2d mapFromEnd, double work) {
    public TaskRoute {
        if (!mapFromBegin.isFinite() || !mapFromEnd.isFinite() || !(work >= 0)) {
            throw new IllegalArgumentException(
                    "A job leads from place to place, not from '%s' to '%s' with work of '%s'."
                            .formatted(mapFromBegin, mapFromEnd, work));
        }
    }

    /// All of it is done at one place.
    public static TaskRoute at(Pose2d mapFromPlace) {
        return new TaskRoute(mapFromPlace, mapFromPlace, 0);
    }
}
