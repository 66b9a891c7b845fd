package rsal.navigation.spread;

import java.util.Arrays;
import java.util.List;
import rsal.data.PlaceObjective;
import rsal.data.Point2d;
import rsal.navigation.rooms.RoomMap;

/// Chooses places for a team on a [ReachableSpace] by an objective other than [PlaceObjective#EVENLY], which is
/// the [Spreader]'s. The same question has the same answer. Immutable; safe for several threads at once.
public final class TeamPlaces {
    private static final int MOST = 128; // places

    private final Candidates candidates;
    private final RoomMap rooms;

    /// Computes the paths between all candidates; takes most of the time.
    public TeamPlaces(ReachableSpace ground) {
        this.candidates = new Candidates(ground);
        this.rooms = RoomMap.of(ground.map());
    }

    /// @return in the map frame, no two nearer to each other than twice the clearance
    /// @throws IllegalArgumentException when there is no room for so many, or fewer than one are wanted
    public List<Point2d> choose(int number, PlaceObjective objective) {
        if (number < 1 || number > MOST) {
            throw new IllegalArgumentException(
                    "From 1 to %d places can be chosen by the objective '%s', not '%d'. Maybe 'evenly' will do."
                            .formatted(MOST, objective.key(), number));
        }
        int[] may = candidates.standing(number);
        int[] chosen = switch (objective) {
            case ROOMS -> new RoomChoice(candidates, may, rooms).choose(number);
            case APART -> new ApartChoice(candidates, may).choose(number);
            case NEAR -> new NearChoice(candidates, may).choose(number);
            case VIEW -> new ViewChoice(candidates, may).choose(number);
            case EVENLY -> throw new IllegalArgumentException("The spreader finds places that are evenly distributed.");
        };
        if (chosen.length < number) {
            throw new IllegalArgumentException(
                    "There is no room for %d places with the objective '%s'. Maybe fewer will do, or a smaller clearance."
                            .formatted(number, objective.key()));
        }
        return Arrays.stream(chosen).mapToObj(candidates::place).toList();
    }
}
