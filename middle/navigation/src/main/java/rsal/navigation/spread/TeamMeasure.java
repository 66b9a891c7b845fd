package rsal.navigation.spread;

import java.util.List;
import rsal.data.Point2d;
import rsal.navigation.rooms.RegionKind;
import rsal.navigation.rooms.RoomMap;

/// How good places for a team are.
///
/// @param rooms how many rooms have at least one of them
/// @param inCorridors how many of them are in corridors
/// @param least path between two of them [m]; infinite for one
/// @param greatest path from anywhere to the nearest of them [m]
/// @param mean path from anywhere to the nearest of them [m]
public record TeamMeasure(int rooms, int inCorridors, double least, double greatest, double mean) {
    /// @param places on the ground
    /// @throws IllegalArgumentException when one is not on the ground, or there is none
    public static TeamMeasure of(ReachableSpace ground, RoomMap rooms, List<Point2d> places) {
        Evenness evenness = ground.measure(places);
        int covered = (int) places.stream()
                .flatMapToInt(place -> rooms.regionAt(place).stream())
                .filter(region -> rooms.regions().get(region).kind() == RegionKind.ROOM)
                .distinct()
                .count();
        int inCorridors = (int) places.stream()
                .flatMapToInt(place -> rooms.regionAt(place).stream())
                .filter(region -> rooms.regions().get(region).kind() == RegionKind.CORRIDOR)
                .count();
        return new TeamMeasure(covered, inCorridors, ground.least(places), evenness.greatest(), evenness.mean());
    }
}
