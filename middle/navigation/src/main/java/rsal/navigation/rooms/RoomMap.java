package rsal.navigation.rooms;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.navigation.grid.DistanceField;

/// A map's rooms, corridors and closets, and the gates between. Each free cell is in one region, except in
/// holes of less than 1 m² that nothing leads to. Depends on nothing but the map and the parameters.
/// Immutable.
public final class RoomMap {
    /// Of cells that are in no region: not free, or in a hole.
    public static final int NONE = -1;

    private final OccupancyGrid map;
    private final int[] regionOf;
    private final List<MapRegion> regions;
    private final List<RoomGate> gates;

    private RoomMap(OccupancyGrid map, int[] regionOf, List<MapRegion> regions, List<RoomGate> gates) {
        this.map = map;
        this.regionOf = regionOf;
        this.regions = List.copyOf(regions);
        this.gates = gates;
    }

    /// With the usual parameters ([RoomParameters#DEFAULT]).
    public static RoomMap of(OccupancyGrid map) {
        return of(map, RoomParameters.DEFAULT);
    }

    /// Finds the rooms of a map: takes loose furniture out, floods the floor from its widest places, and
    /// divides it where floods meet in a narrow place.
    public static RoomMap of(OccupancyGrid map, RoomParameters parameters) {
        var furniture = LooseFurniture.of(map, parameters.furnitureLength());
        OccupancyGrid bare = furniture.withoutSmall();
        RoomDivision division = RoomDivision.of(map, bare, parameters);
        OccupancyGrid barer = furniture.without(bare, division.gates());
        if (!barer.equals(bare)) {
            division = RoomDivision.of(map, barer, parameters);
        }
        int[] regionOf = division.regionOf();
        List<RoomGate> gates = division.gates();
        List<MapRegion> regions = regions(map, division, parameters);
        for (int cell = 0; cell < regionOf.length; cell++) {
            regionOf[cell] = map.cells()[cell] == OccupancyGrid.FREE ? regionOf[cell] : NONE;
        }
        return new RoomMap(map, regionOf, regions, gates);
    }

    private static List<MapRegion> regions(OccupancyGrid map, RoomDivision division, RoomParameters parameters) {
        int count = division.count();
        int[] regionOf = division.regionOf();
        float[] halfWidths = division.halfWidths();
        var free = new int[count];
        var all = new int[count];
        var sums = new double[count];
        DistanceField toNotFree = DistanceField.toNotFree(map);
        var widest = new float[count];
        var clearances = new double[count];
        var middles = new int[count];
        for (int cell = 0; cell < regionOf.length; cell++) {
            int region = regionOf[cell];
            if (region != NONE) {
                all[region]++;
                free[region] += map.cells()[cell] == OccupancyGrid.FREE ? 1 : 0;
                sums[region] += halfWidths[cell];
                widest[region] = Math.max(widest[region], halfWidths[cell]);
                double clearance = Math.min(toNotFree.at(cell) - map.resolution() / 2, halfWidths[cell]);
                if (clearance > clearances[region]) {
                    clearances[region] = clearance;
                    middles[region] = cell;
                }
            }
        }
        double side = map.resolution();
        var regions = new ArrayList<MapRegion>();
        for (int region = 0; region < count; region++) {
            int number = region;
            List<RoomGate> gatesOut = division.gates().stream()
                    .filter(gate -> gate.leadsTo(number))
                    .toList();
            double mean = sums[region] / all[region];
            RegionKind kind = isCorridor(region, all[region] * side * side, mean, widest[region], gatesOut, parameters)
                    ? RegionKind.CORRIDOR
                    : all[region] * side * side < parameters.closetArea() ? RegionKind.CLOSET : RegionKind.ROOM;
            double area = free[region] * side * side;
            regions.add(new MapRegion(region, kind, area, map.middle(middles[region]), clearances[region]));
        }
        return regions;
    }

    /// In a long strip walls are a quarter of its width away on average, in a square a sixth of its side, which
    /// would make it a strip 2.25 times as long as wide.
    private static boolean isCorridor(
            int region,
            double area,
            double meanHalfWidth,
            double widest,
            List<RoomGate> gatesOut,
            RoomParameters parameters) {
        double width = 4 * meanHalfWidth;
        double length = area / (width * width); // in widths, along all bends and branches
        double least = gatesOut.size() >= 3 ? parameters.corridorLength() : 1.5 * parameters.corridorLength();
        long neighbors =
                gatesOut.stream().map(gate -> gate.across(region)).distinct().count();
        return neighbors >= 2
                && length >= least
                && width <= parameters.corridorWidth()
                && 2 * widest <= 1.25 * parameters.corridorWidth();
    }

    /// The map that was divided.
    public OccupancyGrid map() {
        return map;
    }

    /// By number.
    public List<MapRegion> regions() {
        return regions;
    }

    /// By number.
    public List<RoomGate> gates() {
        return gates;
    }

    /// Number of the region that a free cell is in, or [#NONE].
    ///
    /// @param cell its number, as in the map
    public int regionOf(int cell) {
        return regionOf[cell];
    }

    /// Number of the region that a place in the map frame is in; empty where the map is not free, and outside
    /// of it.
    public OptionalInt regionAt(Point2d place) {
        boolean isOnMap = map.contains(map.column(place.x()), map.row(place.y()));
        int region = isOnMap ? regionOf[map.cell(place)] : NONE;
        return region == NONE ? OptionalInt.empty() : OptionalInt.of(region);
    }

    /// The gates that lead out of a region, by number.
    public List<RoomGate> gatesOf(int region) {
        return gates.stream().filter(gate -> gate.leadsTo(region)).toList();
    }

    /// Numbers of the regions to which gates lead from one, each once, in order.
    public List<Integer> neighbors(int region) {
        return gatesOf(region).stream()
                .map(gate -> gate.across(region))
                .distinct()
                .sorted()
                .toList();
    }

    /// How many regions are of a kind.
    public int count(RegionKind kind) {
        return (int) regions.stream().filter(region -> region.kind() == kind).count();
    }
}
