package rsal.device;

import java.util.List;
import java.util.concurrent.CompletionStage;
import rsal.data.PlaceObjective;
import rsal.data.Point2d;
import rsal.data.Pose2d;

/// Finds places for a team on the map: robots can stand there, and they are good for some objective in the
/// space that can be reached from a start. A request moves no robot. The same device gives the same answer to
/// the same request; two devices may choose different places.
public interface PlaceFinder extends Device {
    /// Comes on the scheduler's thread, on large maps after seconds.
    ///
    /// @param mapFromStart somewhere among the places that count: they can all be reached from there
    /// @param count how many places are wanted, at least 1
    /// @param clearance least distance to the next cell that is not free [m]: a robot's radius and some room
    /// @param objective what makes them good
    CompletionStage<Result> find(Pose2d mapFromStart, int count, double clearance, PlaceObjective objective);

    /// The same with places that are evenly distributed ([PlaceObjective#EVENLY]).
    default CompletionStage<Result> find(Pose2d mapFromStart, int count, double clearance) {
        return find(mapFromStart, count, clearance, PlaceObjective.EVENLY);
    }

    sealed interface Result {
        /// @param mapFromPlaces as many as were asked for, each with the clearance, no two nearer than twice
        /// the clearance; from each a robot as wide as that gets to each
        record Found(List<Point2d> mapFromPlaces) implements Result {
            public Found {
                mapFromPlaces = List.copyOf(mapFromPlaces);
            }
        }

        /// @param why in a sentence: the start, the count or the clearance will not do
        record None(String why) implements Result {}
    }
}
