package rsal.navigation.rooms;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.map.Maps;
import rsal.navigation.grid.RandomMaps;
import rsal.settings.FileSource;
import rsal.settings.Location;
import rsal.testkit.DrawnMap;
import rsal.testkit.Trials;

class RoomMapTest {
    private static OccupancyGrid shipped(String name) {
        return new Maps(FileSource.resources(Maps.class, "/")).read(name, Location.of("test"));
    }

    private static int[] regions(RoomMap rooms) {
        var regions = new int[rooms.map().cells().length];
        for (int cell = 0; cell < regions.length; cell++) {
            regions[cell] = rooms.regionOf(cell);
        }
        return regions;
    }

    private static double correlation(RandomFloor.Painted painted) {
        return Segmentations.correlation(painted.rooms(), regions(RoomMap.of(painted.map())));
    }

    /// A corridor with two rooms on each side.
    private static RandomFloor bare() {
        return new RandomFloor(12.6, 12.6)
                .room(0.2, 5.2, 12.4, 7.4)
                .room(0.2, 0.2, 6.2, 5)
                .room(6.4, 0.2, 12.4, 5)
                .room(0.2, 7.6, 6.2, 12.4)
                .room(6.4, 7.6, 12.4, 12.4)
                .door(2, 5, 3, 5.2)
                .door(9, 5, 9.9, 5.2)
                .door(4, 7.4, 5, 7.6)
                .door(7, 7.4, 8.1, 7.6);
    }

    /// Shelves at walls, desks, a table with chairs in the middle.
    private static RandomFloor furnished() {
        return bare().furniture(0.2, 0.2, 0.6, 4)
                .furniture(2, 0.2, 3.6, 1)
                .furniture(2.5, 1.2, 2.9, 1.6)
                .furniture(8.6, 1.8, 10.6, 3)
                .furniture(9, 3.1, 9.4, 3.5)
                .furniture(9.9, 1.3, 10.3, 1.7)
                .furniture(5, 7.6, 6.2, 9)
                .furniture(6.4, 11.6, 12.4, 12.4)
                .furniture(9, 9, 10, 10);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 10, 30, 45, 77})
    void findsTheRoomsOfABareFloorHoweverItIsTurned(double degrees) {
        RandomFloor.Painted painted = bare().paint(0.05, Math.toRadians(degrees));
        RoomMap rooms = RoomMap.of(painted.map());
        assertThat(rooms.count(RegionKind.ROOM)).isEqualTo(4);
        assertThat(rooms.count(RegionKind.CORRIDOR)).isEqualTo(1);
        assertThat(rooms.gates()).hasSize(4);
        assertThat(correlation(painted)).isGreaterThan(0.98);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 20, 45, 60})
    void seesPastFurniture(double degrees) {
        RandomFloor.Painted painted = furnished().paint(0.05, Math.toRadians(degrees));
        RoomMap rooms = RoomMap.of(painted.map());
        assertThat(rooms.count(RegionKind.ROOM)).isEqualTo(4);
        assertThat(rooms.count(RegionKind.CORRIDOR)).isEqualTo(1);
        assertThat(correlation(painted)).isGreaterThan(0.96);
    }

    @Test
    void gatesHaveThePlacesAndWidthsOfDoors() {
        RoomMap rooms = RoomMap.of(bare().paint(0.05, 0).map());
        assertThat(rooms.gates())
                .anySatisfy(gate -> {
                    assertThat(gate.middle().distanceTo(new Point2d(9.45, 5.1))).isLessThan(0.2);
                    assertThat(gate.width()).isBetween(0.8, 0.9001);
                })
                .anySatisfy(gate -> {
                    assertThat(gate.middle().distanceTo(new Point2d(7.55, 7.5))).isLessThan(0.2);
                    assertThat(gate.width()).isBetween(1.0, 1.1001);
                    assertThat(gate.from().distanceTo(gate.to())).isBetween(0.9, 1.3);
                });
    }

    @Test
    void anOpenPlanIsOneRoom() {
        RandomFloor plan = new RandomFloor(14, 11).room(0.2, 0.2, 13.8, 10.8);
        for (int desk = 0; desk < 8; desk++) {
            double left = 2 + 3 * (desk % 4);
            double bottom = desk < 4 ? 2.5 : 7;
            plan.furniture(left, bottom, left + 1.5, bottom + 0.8);
        }
        assertThat(RoomMap.of(plan.paint(0.05, 0).map()).regions())
                .singleElement()
                .satisfies(region -> assertThat(region.kind()).isEqualTo(RegionKind.ROOM));
    }

    @Test
    void aCavesHallsAreRooms() {
        var cave = DrawnMap.grid(0.5, """
                ############################################
                #####......############......###############
                ###..........########............###########
                ##............#####................#########
                #..............###..................########
                #....................................#######
                #....................................#######
                #..............###..................########
                ##............#####................#########
                ###..........########.............##########
                #####.......##########..........############
                #########..###############..################
                ########....#############.....##############
                ######.......###########........############
                #####........##########..........###########
                ####..........########............##########
                #####........##########..........###########
                ######......############........############
                ########..################....##############
                ############################################""");
        RoomMap rooms = RoomMap.of(cave.grid());
        assertThat(rooms.regions()).hasSize(4);
        assertThat(rooms.gates()).hasSize(3);
    }

    @Test
    void aWardrobeBehindADoorIsACloset() {
        RandomFloor plan = new RandomFloor(8, 6)
                .room(0.2, 0.2, 5.8, 5.8)
                .room(6, 0.2, 7.4, 1.7)
                .door(5.8, 0.5, 6, 1.2);
        assertThat(RoomMap.of(plan.paint(0.05, 0).map()).regions())
                .extracting(MapRegion::kind)
                .containsExactly(RegionKind.ROOM, RegionKind.CLOSET);
    }

    @Trials(
            value = {"1", "2", "3", "4", "5", "6", "7", "8", "9", "10", "11", "12"},
            landing = 4)
    void findsTheRoomsOfRandomOffices(long seed) {
        RandomFloor plan = RandomFloor.office(new SplittableRandom(seed));
        RandomFloor.Painted painted = plan.paint(0.05, 0);
        RoomMap rooms = RoomMap.of(painted.map());
        assertThat(rooms.regions()).as("seed %d", seed).hasSize(plan.rooms());
        assertThat(rooms.count(RegionKind.CORRIDOR)).as("seed %d", seed).isEqualTo(1);
        assertThat(correlation(painted)).as("seed %d", seed).isGreaterThan(0.98);
    }

    @Trials({"1", "2", "3", "4"})
    void moreResolutionDoesNotChangeTheirNumber(long seed) {
        RandomFloor plan = RandomFloor.office(new SplittableRandom(seed));
        for (double resolution : new double[] {0.1, 0.05, 0.025}) {
            assertThat(RoomMap.of(plan.paint(resolution, 0.3).map()).regions())
                    .as("seed %d at %s m", seed, resolution)
                    .hasSize(plan.rooms());
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"office", "four-rooms"})
    void rotatedAndMirroredMapsHaveTheSameRooms(String name) {
        OccupancyGrid map = shipped(name);
        RoomMap rooms = RoomMap.of(map);
        for (int rotation = 1; rotation < 8; rotation++) {
            OccupancyGrid other = rotated(map, rotation);
            RoomMap found = RoomMap.of(other);
            var back = new int[map.cells().length];
            for (int cell = 0; cell < back.length; cell++) {
                back[cell] = found.regionOf(rotated(map, cell, rotation));
            }
            assertThat(found.regions()).as("rotation %d", rotation).hasSameSizeAs(rooms.regions());
            assertThat(Segmentations.correlation(regions(rooms), back))
                    .as("rotation %d", rotation)
                    .isGreaterThan(0.995);
        }
    }

    /// @param rotation bit 0: mirrored left to right, 1: upside down, 2: along the diagonal
    private static int rotated(OccupancyGrid map, int cell, int rotation) {
        int column = cell % map.width();
        int row = cell / map.width();
        column = (rotation & 1) == 0 ? column : map.width() - 1 - column;
        row = (rotation & 2) == 0 ? row : map.height() - 1 - row;
        return (rotation & 4) == 0 ? row * map.width() + column : column * map.height() + row;
    }

    private static OccupancyGrid rotated(OccupancyGrid map, int rotation) {
        var cells = new byte[map.cells().length];
        for (int cell = 0; cell < cells.length; cell++) {
            cells[rotated(map, cell, rotation)] = map.cells()[cell];
        }
        boolean isLying = (rotation & 4) == 0;
        return new OccupancyGrid(
                isLying ? map.width() : map.height(),
                isLying ? map.height() : map.width(),
                map.resolution(),
                0,
                0,
                cells);
    }

    @Test
    void theShippedOfficeHasOneCorridorAndARoomBehindEachDoor() {
        RoomMap rooms = RoomMap.of(shipped("office"));
        assertThat(rooms.count(RegionKind.CORRIDOR)).isEqualTo(1);
        assertThat(rooms.count(RegionKind.ROOM)).isEqualTo(26);
        MapRegion corridor = rooms.regions().stream()
                .filter(region -> region.kind() == RegionKind.CORRIDOR)
                .findFirst()
                .orElseThrow();
        assertThat(rooms.neighbors(corridor.number())).hasSize(26);
        assertThat(RoomMap.of(shipped("four-rooms")).regions()).hasSize(4);
    }

    @Trials(
            value = {
                "1", "2", "3", "4", "5", "6", "7", "8", "9", "10", "11", "12", "13", "14", "15", "16", "17", "18", "19",
                "20"
            },
            landing = 5)
    void eachFreeCellIsInOneConnectedRegionAndGatesLieBetweenTwo(long seed) {
        var random = new SplittableRandom(seed);
        OccupancyGrid noise =
                RandomMaps.of(random, 1 + random.nextInt(120), 1 + random.nextInt(120), random.nextDouble() * 0.3);
        assertSound(RoomMap.of(noise), seed);
        assertSound(
                RoomMap.of(RandomFloor.office(random)
                        .paint(0.1, random.nextDouble())
                        .map()),
                seed);
    }

    private static void assertSound(RoomMap rooms, long seed) {
        OccupancyGrid map = rooms.map();
        assertConnectedWithGatesBetween(map, seed);
        double cell = map.resolution() * map.resolution();
        var counts = new int[rooms.regions().size()];
        for (int i = 0; i < map.cells().length; i++) {
            int region = rooms.regionOf(i);
            if (region != RoomMap.NONE) {
                assertThat(map.cells()[i]).as("seed %d", seed).isEqualTo(OccupancyGrid.FREE);
                counts[region]++;
            }
        }
        for (List<Integer> hole : holes(rooms)) {
            assertThat(hole.size() * cell).as("seed %d, hole", seed).isLessThan(1);
        }
        for (MapRegion region : rooms.regions()) {
            assertThat(region.area()).as("seed %d", seed).isCloseTo(counts[region.number()] * cell, within(1e-6));
            assertThat(rooms.regionAt(region.middle()))
                    .as("seed %d, %s", seed, region)
                    .hasValue(region.number());
        }
        var numbers = new HashSet<Integer>();
        for (RoomGate gate : rooms.gates()) {
            assertThat(gate.one()).as("seed %d", seed).isLessThan(gate.other());
            assertThat(gate.other()).as("seed %d", seed).isLessThan(counts.length);
            assertThat(gate.width()).as("seed %d", seed).isGreaterThanOrEqualTo(0.3);
            assertThat(numbers.add(gate.number())).isTrue();
            assertThat(rooms.neighbors(gate.one())).contains(gate.other());
            assertThat(rooms.neighbors(gate.other())).contains(gate.one());
        }
    }

    /// On the map without furniture, on which regions are found.
    private static void assertConnectedWithGatesBetween(OccupancyGrid map, long seed) {
        RoomParameters parameters = RoomParameters.DEFAULT;
        var furniture = LooseFurniture.of(map, parameters.furnitureLength());
        OccupancyGrid bare = furniture.withoutSmall();
        RoomDivision division = RoomDivision.of(map, bare, parameters);
        division = RoomDivision.of(map, furniture.without(bare, division.gates()), parameters);
        int[] regionOf = division.regionOf();
        for (int region = 0; region < division.count(); region++) {
            assertThat(parts(map, regionOf, region))
                    .as("seed %d, region %d", seed, region)
                    .isEqualTo(1);
        }
        for (RoomGate gate : division.gates()) {
            for (int region : new int[] {gate.one(), gate.other()}) {
                assertThat(distance(map, regionOf, region, gate.middle()))
                        .as("seed %d, from %s to region %d", seed, gate, region)
                        .isLessThanOrEqualTo(2.5 * map.resolution());
            }
        }
    }

    /// How many parts a region has that are connected along sides, by a flood.
    private static int parts(OccupancyGrid map, int[] regionOf, int region) {
        var seen = new boolean[regionOf.length];
        int parts = 0;
        for (int first = 0; first < seen.length; first++) {
            if (regionOf[first] == region && !seen[first]) {
                parts++;
                var flooded = new ArrayList<Integer>();
                flooded.add(first);
                seen[first] = true;
                for (int next = 0; next < flooded.size(); next++) {
                    for (int to : beside(map, flooded.get(next))) {
                        if (to >= 0 && to < seen.length && !seen[to] && regionOf[to] == region) {
                            seen[to] = true;
                            flooded.add(to);
                        }
                    }
                }
            }
        }
        return parts;
    }

    /// From a place to the middle of the nearest cell of a region [m].
    private static double distance(OccupancyGrid map, int[] regionOf, int region, Point2d place) {
        double nearest = Double.POSITIVE_INFINITY;
        for (int cell = 0; cell < regionOf.length; cell++) {
            if (regionOf[cell] == region) {
                nearest = Math.min(nearest, map.middle(cell).distanceTo(place));
            }
        }
        return nearest;
    }

    /// Some of them are off the map.
    private static int[] beside(OccupancyGrid map, int cell) {
        int column = cell % map.width();
        return new int[] {
            column + 1 < map.width() ? cell + 1 : -1, column > 0 ? cell - 1 : -1, cell + map.width(), cell - map.width()
        };
    }

    @Test
    void aMapThatIsAllFreeIsOneRoom() {
        var map = new OccupancyGrid(60, 40, 0.1, -1, 2, new byte[60 * 40]);
        assertThat(map.cells()).containsOnly(OccupancyGrid.FREE);
        RoomMap rooms = RoomMap.of(map);
        assertThat(rooms.regions()).singleElement().satisfies(region -> {
            assertThat(region.kind()).isEqualTo(RegionKind.ROOM);
            assertThat(region.area()).isCloseTo(24, within(1e-6));
        });
        assertThat(rooms.gates()).isEmpty();
        assertSound(rooms, 0);
    }

    @Test
    void aHallAroundAnUnknownPatchIsOneRoom() {
        OccupancyGrid map = new RandomFloor(10.4, 8.4)
                .room(0.2, 0.2, 10.2, 8.2)
                .paint(0.1, 0)
                .map();
        for (int cell = 0; cell < map.cells().length; cell++) {
            Point2d middle = map.middle(cell);
            if (Math.abs(middle.x() - 5.2) < 1 && Math.abs(middle.y() - 4.2) < 1) {
                map.cells()[cell] = OccupancyGrid.UNKNOWN;
            }
        }
        RoomMap rooms = RoomMap.of(map);
        assertThat(rooms.regions()).singleElement().satisfies(region -> {
            assertThat(region.kind()).isEqualTo(RegionKind.ROOM);
            assertThat(region.area()).isCloseTo(76, within(1e-6));
        });
        assertThat(rooms.gates()).isEmpty();
        assertThat(rooms.regionAt(new Point2d(5.2, 4.2))).isEmpty();
        assertSound(rooms, 0);
    }

    private static org.assertj.core.data.Offset<Double> within(double most) {
        return org.assertj.core.data.Offset.offset(most);
    }

    /// Free cells in no region, by what is connected along sides.
    private static List<List<Integer>> holes(RoomMap rooms) {
        OccupancyGrid map = rooms.map();
        var seen = new boolean[map.cells().length];
        var holes = new ArrayList<List<Integer>>();
        for (int first = 0; first < seen.length; first++) {
            if (isHole(rooms, first) && !seen[first]) {
                var hole = new ArrayList<Integer>();
                hole.add(first);
                seen[first] = true;
                for (int next = 0; next < hole.size(); next++) {
                    int at = hole.get(next);
                    for (int to : beside(map, at)) {
                        if (to >= 0 && to < seen.length && !seen[to] && isHole(rooms, to)) {
                            seen[to] = true;
                            hole.add(to);
                        }
                    }
                }
                holes.add(hole);
            }
        }
        return holes;
    }

    private static boolean isHole(RoomMap rooms, int cell) {
        return rooms.map().cells()[cell] == OccupancyGrid.FREE && rooms.regionOf(cell) == RoomMap.NONE;
    }

    @Test
    void aMapWithoutAFreeCellHasNoRooms() {
        RoomMap rooms = RoomMap.of(DrawnMap.grid(0.5, "#??#").grid());
        assertThat(rooms.regions()).isEmpty();
        assertThat(rooms.regionAt(new Point2d(0.2, 0.2))).isEmpty();
        assertThat(rooms.regionAt(new Point2d(Double.NaN, 1e9))).isEmpty();
    }

    @Test
    void parametersOutOfRangeAreRefused() {
        assertThatThrownBy(() -> new RoomParameters(0.3, 2, 1.5, 0.6, 0.4, 3, 4, 5.5, 4, 5))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("narrowing");
        assertThatThrownBy(() -> new RoomParameters(0.3, Double.NaN, 0.8, 0.6, 0.4, 3, 4, 5.5, 4, 5))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("gateWidth");
    }
}
