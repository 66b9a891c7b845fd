package rsal.navigation.passage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.grid.RandomMaps;
import rsal.navigation.wavefront.CostMap;
import rsal.testkit.Trials;

class PassagesTest {
    /// A corridor of 1.2 m with a corner between two rooms.
    private static final OccupancyGrid BENT = DrawnMaps.of(0.4, """
            ####################
            #........###########
            #........###########
            #..............#####
            #..............#####
            #..............#####
            #........###...#####
            ############...#####
            ############...#####
            #########.........##
            #########.........##
            #########.........##
            #########.........##
            #########.........##
            #########.........##
            ####################""");

    /// A room that is one wide place around a block, with a gap between the block and the wall below.
    private static final OccupancyGrid LOOP = DrawnMaps.of(0.4, """
            ####################
            #..................#
            #..................#
            #..................#
            #..................#
            #..................#
            #.....#######......#
            #.....#######......#
            #.....#######......#
            #.....#######......#
            #..................#
            #..................#
            ####################""");

    @Test
    void aDoorOfASingleWallIsAPassageWithTwoGates() {
        Passages found = DrawnMaps.passages(DrawnMaps.DOOR);

        assertThat(found.all()).hasSize(1);
        Passage door = found.all().getFirst();
        assertThat(door.gates()).hasSize(2);
        assertThat(door.mapFromMiddle().x()).isCloseTo(4.3, within(0.2));
        assertThat(door.gates())
                .allSatisfy(gate -> assertThat(gate.waitingPlaces()).isNotEmpty());
        assertThat(Math.abs(door.gates().getFirst().mapFromGate().x()
                        - door.gates().getLast().mapFromGate().x()))
                .isBetween(1.2, 2.2);
    }

    /// Gates at which nobody can wait are closed, but not the last wide place that robots can be in:
    /// without it no passage would be left.
    @ParameterizedTest
    @ValueSource(ints = {45, 46, 47})
    void closingGatesKeepsTheLastWidePlace(int side) {
        OccupancyGrid map = twoRooms(side);
        var search = new PassageSearch(
                DrawnMaps.open(map), DistanceField.toNotFree(map), DrawnMaps.BODY, Passages.halfWidth(DrawnMaps.BODY));
        Passages found = search.find();
        assertThat(found.all()).hasSize(1);

        boolean closed = true;
        for (int round = 0; round < 10 && closed; round++) {
            closed = search.closeGatesWithoutRoom(withoutWaitingPlaces(map, found));
            found = search.find();
            assertThat(found.all()).as("round %d", round).isNotEmpty();
        }
        assertThat(closed).isFalse();
    }

    private static Passages withoutWaitingPlaces(OccupancyGrid map, Passages passages) {
        List<Passage> all = passages.all().stream()
                .map(passage -> new Passage(
                        passage.index(),
                        passage.mapFromMiddle(),
                        passage.gates().stream()
                                .map(gate -> new Gate(gate.mapFromGate(), gate.heading(), List.of()))
                                .toList(),
                        passage.mapFromCells()))
                .toList();
        return Passages.of(map, new int[map.cells().length], all);
    }

    /// @param side of square rooms with a door of 0.8 m between them, in cells of 5 cm
    private static OccupancyGrid twoRooms(int side) {
        int width = 2 * side + 3 * 4;
        int height = side + 2 * 4;
        var cells = new byte[width * height];
        Arrays.fill(cells, OccupancyGrid.OCCUPIED);
        for (int cell = 0; cell < cells.length; cell++) {
            int column = cell % width;
            int row = cell / width;
            boolean isRoom = row >= 4 && row < 4 + side && column >= 4 && column < width - 4;
            boolean isWall = column >= 4 + side && column < 8 + side && Math.abs(2 * row + 1 - height) > 16;
            if (isRoom && !isWall) {
                cells[cell] = OccupancyGrid.FREE;
            }
        }
        return new OccupancyGrid(width, height, 0.05, 0, 0, cells);
    }

    /// A robot that has left the door could not stand clear of it: this is the limit.
    @Test
    void roomsWithoutAWidePlaceHaveNoPassages() {
        assertThat(DrawnMaps.passages(twoRooms(40)).all()).isEmpty();
    }

    @Test
    void aBentCorridorIsOnePassage() {
        Passages found = DrawnMaps.passages(BENT);

        assertThat(found.all()).hasSize(1);
        assertThat(found.all().getFirst().gates()).hasSize(2);
    }

    @Test
    void aGapInALoopOfOneWidePlaceIsFound() {
        Passages found = DrawnMaps.passages(LOOP);

        assertThat(found.all()).hasSize(1);
        assertThat(found.all().getFirst().gates()).hasSize(2);
        assertThat(found.at(new Point2d(3.8, 0.8))).contains(found.all().getFirst());
    }

    @Test
    void aPathEntersAndLeavesADoor() {
        Passages found = DrawnMaps.passages(DrawnMaps.DOOR);
        var path = List.of(new Point2d(1, 1.8), new Point2d(7, 1.8));

        List<Passages.Crossing> crossings = found.crossings(path);

        assertThat(crossings).hasSize(1);
        assertThat(crossings.getFirst().from()).isBetween(2.3, 3.2);
        assertThat(crossings.getFirst().to()).isBetween(3.4, 4.2);
        assertThat(found.crossings(List.of(new Point2d(1, 0.6), new Point2d(3, 3))))
                .isEmpty();
    }

    @Trials(
            value = {"1", "2", "3", "4", "5", "6"},
            landing = 2)
    void theFloodIsAsDeepAsASlowOne(long seed) {
        var random = new SplittableRandom(seed);
        OccupancyGrid map = RandomMaps.of(random, 40, 30, 0.3 * random.nextDouble());
        boolean[] open = inside(map);
        var wide = new boolean[open.length];
        for (int i = 0; i < wide.length; i++) {
            wide[i] = random.nextInt(40) == 0;
        }
        var flood = new WideFlood(map.width(), map.height(), cell -> open[cell], cell -> wide[cell]);
        int[] slow = slowDistances(map.width(), open, wide);
        for (int cell = 0; cell < open.length; cell++) {
            assertThat(flood.distance(cell)).as("cell %d, seed %d", cell, seed).isEqualTo(slow[cell]);
            if (flood.isReached(cell)) {
                assertThat(wide[flood.source(cell)]).isTrue();
            }
        }
    }

    private static boolean[] inside(OccupancyGrid map) {
        var open = new boolean[map.cells().length];
        for (int row = 1; row < map.height() - 1; row++) {
            for (int column = 1; column < map.width() - 1; column++) {
                open[row * map.width() + column] = map.at(column, row) == OccupancyGrid.FREE;
            }
        }
        return open;
    }

    /// Bellman and Ford: again and again over all, until nothing gets nearer.
    private static int[] slowDistances(int width, boolean[] open, boolean[] wide) {
        var distances = new int[open.length];
        for (int cell = 0; cell < open.length; cell++) {
            distances[cell] = open[cell] && wide[cell] ? 0 : Integer.MAX_VALUE;
        }
        int[] sides = {1, -1, width, -width, width + 1, width - 1, -width + 1, -width - 1};
        boolean changed = true;
        while (changed) {
            changed = false;
            for (int cell = 0; cell < open.length; cell++) {
                for (int side = 0; side < 8 && open[cell]; side++) {
                    int from = distances[cell + sides[side]];
                    int far = from == Integer.MAX_VALUE ? from : from + (side < 4 ? 5 : 7);
                    if (open[cell + sides[side]] && far < distances[cell]) {
                        distances[cell] = far;
                        changed = true;
                    }
                }
            }
        }
        return distances;
    }

    @Trials(
            value = {"1", "2", "3", "4", "5", "6", "7", "8"},
            landing = 2)
    void waitingPlacesOfRandomMapsLeaveTheGateOpen(long seed) {
        OccupancyGrid map = rooms(new SplittableRandom(seed));
        CostMap open = DrawnMaps.open(map);
        DistanceField toNotFree = DistanceField.toNotFree(map);
        Passages found = DrawnMaps.passages(map);

        assertThat(found.all())
                .as("seed %d", seed)
                .isEqualTo(DrawnMaps.passages(map).all());
        for (Passage passage : found.all()) {
            for (Point2d cell : passage.mapFromCells()) {
                assertThat(open.isOpen(map.cell(cell))).isTrue();
                assertThat(found.at(cell)).contains(passage);
            }
            for (Gate gate : passage.gates()) {
                assertThat(found.at(gate.mapFromGate())).isEmpty();
                int around = reached(map, open, found, gate, gate.mapFromGate(), 0);
                for (Point2d place : gate.waitingPlaces()) {
                    assertThat(toNotFree.at(map.cell(place))).isGreaterThan((float) DrawnMaps.BODY);
                    assertThat(found.at(place)).isEmpty();
                    assertThat(reached(map, open, found, gate, place, 2 * DrawnMaps.BODY))
                            .isGreaterThanOrEqualTo(around / 2);
                }
            }
        }
    }

    /// Rooms of random sizes with doors of 0.7 to 1.2 m between them, and some pillars.
    private static OccupancyGrid rooms(SplittableRandom random) {
        int width = 240;
        int height = 160;
        var cells = new byte[width * height];
        int[] walls = {0, 70 + random.nextInt(20), 150 + random.nextInt(20), width - 1};
        int across = 60 + random.nextInt(40);
        for (int cell = 0; cell < cells.length; cell++) {
            int column = cell % width;
            int row = cell / width;
            boolean isWall = Arrays.stream(walls).anyMatch(wall -> wall == column)
                    || row == 0
                    || row == height - 1
                    || row == across;
            cells[cell] = isWall ? OccupancyGrid.OCCUPIED : OccupancyGrid.FREE;
        }
        for (int wall : new int[] {walls[1], walls[2]}) {
            open(cells, width, wall, 10 + random.nextInt(25), 0, 14 + random.nextInt(11));
            open(cells, width, wall, across + 10 + random.nextInt(25), 0, 14 + random.nextInt(11));
        }
        open(cells, width, 10 + random.nextInt(40), across, 14 + random.nextInt(11), 0);
        for (int i = 0; i < 4; i++) {
            int pillar = (5 + random.nextInt(height - 15)) * width + 5 + random.nextInt(width - 15);
            for (int j = 0; j < 25; j++) {
                cells[pillar + j / 5 * width + j % 5] = OccupancyGrid.OCCUPIED;
            }
        }
        return new OccupancyGrid(width, height, 0.05, 0, 0, cells);
    }

    private static void open(byte[] cells, int width, int column, int row, int columns, int rows) {
        for (int i = 0; i <= Math.max(columns, rows); i++) {
            cells[(row + (rows > 0 ? i : 0)) * width + column + (columns > 0 ? i : 0)] = OccupancyGrid.FREE;
        }
    }

    /// How many cells within 3.5 m of a gate can be reached from it outside of passages, without coming near a place.
    private static int reached(OccupancyGrid map, CostMap open, Passages found, Gate gate, Point2d avoided, double by) {
        var seen = new boolean[map.cells().length];
        var next = new ArrayDeque<Integer>();
        next.add(map.cell(gate.mapFromGate()));
        seen[next.peek()] = true;
        int count = 0;
        while (!next.isEmpty()) {
            int cell = next.poll();
            count++;
            for (int side : new int[] {1, -1, map.width(), -map.width()}) {
                Point2d place = map.middle(cell + side);
                if (!seen[cell + side]
                        && open.isOpen(cell + side)
                        && found.at(place).isEmpty()
                        && place.distanceTo(gate.mapFromGate()) <= 3.5
                        && place.distanceTo(avoided) >= by) {
                    seen[cell + side] = true;
                    next.add(cell + side);
                }
            }
        }
        return count;
    }
}
