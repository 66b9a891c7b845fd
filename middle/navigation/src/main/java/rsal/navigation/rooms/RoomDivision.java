package rsal.navigation.rooms;

import java.util.Arrays;
import java.util.List;
import rsal.data.OccupancyGrid;

/// A floor without some of its furniture, divided into regions.
///
/// @param regionOf number of each cell's region, also under furniture, or [RoomMap#NONE]; not to be written to
/// @param count of regions
/// @param halfWidths how far walls are from each cell [m]; not to be written to
record RoomDivision(int[] regionOf, int count, float[] halfWidths, List<RoomGate> gates) {
    /// @param map with all furniture: what is free counts for areas
    /// @param bare the same without furniture
    static RoomDivision of(OccupancyGrid map, OccupancyGrid bare, RoomParameters parameters) {
        var basins = new Basins(bare, parameters);
        var graph = new RegionGraph(map, basins, parameters);
        var numbers = new int[basins.numbers()];
        Arrays.fill(numbers, RoomMap.NONE);
        int[] basinOf = basins.basinOf();
        var regionOf = new int[basinOf.length];
        Arrays.fill(regionOf, RoomMap.NONE);
        int count = 0;
        for (int cell = 0; cell < regionOf.length; cell++) {
            int region = basinOf[cell] == Basins.NONE ? Basins.NONE : graph.regionOf(basinOf[cell]);
            if (region != Basins.NONE) {
                numbers[region] = numbers[region] == RoomMap.NONE ? count++ : numbers[region];
                regionOf[cell] = numbers[region];
            }
        }
        float[] halfWidths = basins.halfWidths();
        var finder = new GateFinder(map, regionOf, halfWidths, parameters.leastGate());
        return new RoomDivision(regionOf, count, halfWidths, finder.gates());
    }
}
