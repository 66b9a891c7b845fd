package rsal.agents.pursuit.strategy;

import java.util.Collections;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Supplier;
import java.util.random.RandomGenerator;
import rsal.data.Point2d;
import rsal.data.Pose2d;

/// What a hunter knows when it asks its strategy. Poses are in the map frame.
///
/// @param time of the run [s]
/// @param robot the hunter's id
/// @param mapFromBase where it believes to be
/// @param hunters where hunters said to be lately, by id, itself included
/// @param prey where prey that are not caught were seen, or said to be, lately, by id
/// @param assigned the prey that the parameter `assignment` gives to this hunter; empty while there is none
/// @param goals where the other hunters drive by what they said last, by id
/// @param catchDistance [m]
/// @param sight how far the hunters see prey [m]; 0 where prey report their poses
/// @param floor the places where robots can be, computed at the first request; empty without a map
/// @param random a stream of the hunter's own
public record PursuitView(
        double time,
        String robot,
        Pose2d mapFromBase,
        SortedMap<String, Pose2d> hunters,
        SortedMap<String, Pose2d> prey,
        Optional<String> assigned,
        SortedMap<String, Point2d> goals,
        double catchDistance,
        double sight,
        Supplier<Optional<FloorGraph>> floor,
        RandomGenerator random) {
    public PursuitView {
        hunters = Collections.unmodifiableSortedMap(new TreeMap<>(hunters));
        prey = Collections.unmodifiableSortedMap(new TreeMap<>(prey));
        goals = Collections.unmodifiableSortedMap(new TreeMap<>(goals));
    }

    /// To drive to the newest pose of the assigned prey; empty while there is none.
    public Optional<PursuitOrder> direct() {
        return assigned.flatMap(
                id -> Optional.ofNullable(prey.get(id)).map(at -> PursuitOrder.hunt(id, at, "hunting")));
    }
}
