package rsal.sim.office;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntPredicate;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rsal.data.OccupancyGrid;
import rsal.map.Maps;
import rsal.settings.FileSource;
import rsal.settings.Location;

class OfficeFloorTest {
    private static final OccupancyGrid MAP =
            new Maps(FileSource.folder(Path.of("."))).read("office", Location.of("test"));
    private static final double[] CLEARANCES = clearances();

    @Test
    void theMapIsWhatTheProgramDraws() throws IOException {
        assertThat(pixels(ImageIO.read(resource("office.png")))).isEqualTo(pixels(OfficeFloor.draw()));
        assertThat(new String(resource("office.yaml").readAllBytes(), StandardCharsets.UTF_8))
                .isEqualTo(OfficeFloor.yaml());
    }

    @Test
    void itHasTheMeasuresOfTheThesisFloor() {
        assertThat(MAP.width() * MAP.resolution()).isCloseTo(62.95, within(1e-9));
        assertThat(MAP.height() * MAP.resolution()).isCloseTo(15.6, within(1e-9));
        assertThat(MAP.originX()).isEqualTo(-31.475);
        assertThat(MAP.originY()).isEqualTo(-7.8);
        assertThat(MAP.cells()).containsOnly(OccupancyGrid.FREE, OccupancyGrid.OCCUPIED);
    }

    @Test
    void wallsGoAllRound() {
        for (int column = 0; column < MAP.width(); column++) {
            assertThat(MAP.at(column, 0)).isEqualTo(OccupancyGrid.OCCUPIED);
            assertThat(MAP.at(column, MAP.height() - 1)).isEqualTo(OccupancyGrid.OCCUPIED);
        }
        for (int row = 0; row < MAP.height(); row++) {
            assertThat(MAP.at(0, row)).isEqualTo(OccupancyGrid.OCCUPIED);
            assertThat(MAP.at(MAP.width() - 1, row)).isEqualTo(OccupancyGrid.OCCUPIED);
        }
    }

    @Test
    void theCorridorIsFreeFromEndToEnd() {
        for (double x = -31.2; x < 31.2; x += 0.05) {
            for (double y = -2.35; y < -0.45; y += 0.05) {
                assertThat(MAP.isFree(x, y)).as("(%s, %s)", x, y).isTrue();
            }
        }
    }

    @Test
    void tenPillarsStandInItsNorthEdge() {
        List<Double> pillars = runs(0.0, -31.2, 31.2, OccupancyGrid.OCCUPIED);
        assertThat(pillars).hasSize(10).allSatisfy(length -> assertThat(length).isCloseTo(2.5, within(1e-9)));
    }

    @Test
    void doorsAreWideEnoughForARobot() {
        List<Double> doors = new ArrayList<>(runs(0.475, -31.2, 31.2, OccupancyGrid.FREE));
        doors.addAll(runs(-2.475, -31.2, 31.2, OccupancyGrid.FREE));
        assertThat(doors).hasSize(OfficeFloor.rooms().size() + 3); // three rooms have two
        assertThat(doors).allSatisfy(width -> assertThat(width).isBetween(0.9 - 1e-9, 1.4 + 1e-9));
    }

    static List<OfficeFloor.Room> rooms() {
        return OfficeFloor.rooms();
    }

    @ParameterizedTest
    @MethodSource("rooms")
    void aPioneerGetsIntoEveryRoomFromTheCorridor(OfficeFloor.Room room) {
        boolean[] reached = reachableWith(0.40); // 0.35 m from its middle to its corners, and some margin
        int inRoom = 0;
        for (int i = 0; i < reached.length; i++) {
            double x = MAP.x(i % MAP.width());
            double y = MAP.y(i / MAP.width());
            boolean inside = x > room.west() && x < room.east() && y > room.south() && y < room.north();
            inRoom += inside && reached[i] ? 1 : 0;
        }
        assertThat(inRoom * MAP.resolution() * MAP.resolution())
                .as("area of middles in %s [m²]", room)
                .isGreaterThan(1.5);
    }

    /// Where a narrow robot gets in, it must not have far to back out before it can turn.
    @Test
    void noGapIsTooNarrowToTurnAndTooDeepToBackOut() {
        boolean[] entered = reachableWith(0.2);
        boolean[] turning = reachableWith(0.4);
        int deepest = (int) Math.round(0.55 / MAP.resolution());
        var traps = new ArrayList<String>();
        for (int i = 0; i < entered.length; i++) {
            if (entered[i] && !anyWithin(turning, i, deepest)) {
                traps.add("(%.2f, %.2f)".formatted(MAP.x(i % MAP.width()), MAP.y(i / MAP.width())));
            }
        }
        assertThat(traps).isEmpty();
    }

    /// Lengths [m] of the unbroken stretches of a value on a line from west to east.
    private static List<Double> runs(double y, double west, double east, byte value) {
        var runs = new ArrayList<Double>();
        int length = 0;
        for (int column = MAP.column(west); column <= MAP.column(east); column++) {
            if (MAP.at(column, MAP.row(y)) == value) {
                length++;
            } else if (length > 0) {
                runs.add(length * MAP.resolution());
                length = 0;
            }
        }
        return runs;
    }

    /// Cells that the middle of a robot gets to from the corridor, when it keeps some distance to everything.
    private static boolean[] reachableWith(double clearance) {
        IntPredicate open = cell -> CLEARANCES[cell] >= clearance;
        boolean[] reached = new boolean[CLEARANCES.length];
        var queue = new ArrayDeque<Integer>();
        int start = MAP.row(-1.4) * MAP.width() + MAP.column(0);
        reached[start] = true;
        queue.add(start);
        while (!queue.isEmpty()) {
            int cell = queue.remove();
            for (int next : new int[] {cell - 1, cell + 1, cell - MAP.width(), cell + MAP.width()}) {
                if (!reached[next] && open.test(next)) {
                    reached[next] = true;
                    queue.add(next);
                }
            }
        }
        return reached;
    }

    private static boolean anyWithin(boolean[] cells, int center, int distance) {
        for (int up = -distance; up <= distance; up++) {
            for (int right = -distance; right <= distance; right++) {
                int cell = center + up * MAP.width() + right;
                if (up * up + right * right <= distance * distance && cell >= 0 && cell < cells.length && cells[cell]) {
                    return true;
                }
            }
        }
        return false;
    }

    /// From the middle of each cell to the nearest occupied one [m], looked up the slow way; 1 m at most.
    private static double[] clearances() {
        double[] clearances = new double[MAP.width() * MAP.height()];
        int far = (int) Math.round(1 / MAP.resolution());
        Arrays.fill(clearances, 1);
        for (int i = 0; i < clearances.length; i++) {
            if (MAP.cells()[i] == OccupancyGrid.OCCUPIED) {
                spread(clearances, i % MAP.width(), i / MAP.width(), far);
            }
        }
        return clearances;
    }

    private static void spread(double[] clearances, int column, int row, int far) {
        boolean inside = isOccupied(column - 1, row)
                && isOccupied(column + 1, row)
                && isOccupied(column, row - 1)
                && isOccupied(column, row + 1);
        if (inside) {
            clearances[row * MAP.width() + column] = 0;
            return; // its neighbors are nearer to everything
        }
        for (int r = Math.max(0, row - far); r <= Math.min(MAP.height() - 1, row + far); r++) {
            for (int c = Math.max(0, column - far); c <= Math.min(MAP.width() - 1, column + far); c++) {
                double right = Math.max(0, Math.abs(c - column) - 0.5);
                double up = Math.max(0, Math.abs(r - row) - 0.5);
                double gap = c == column && r == row ? 0 : Math.hypot(right, up) * MAP.resolution();
                clearances[r * MAP.width() + c] = Math.min(clearances[r * MAP.width() + c], gap);
            }
        }
    }

    private static boolean isOccupied(int column, int row) {
        return !MAP.contains(column, row) || MAP.at(column, row) == OccupancyGrid.OCCUPIED;
    }

    private static byte[] pixels(BufferedImage image) {
        return ((DataBufferByte) image.getRaster().getDataBuffer()).getData();
    }

    private static InputStream resource(String name) {
        InputStream in = Maps.class.getResourceAsStream("/rsal/maps/" + name);
        assertThat(in).as(name).isNotNull();
        return in;
    }
}
