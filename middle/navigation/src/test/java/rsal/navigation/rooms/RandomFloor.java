package rsal.navigation.rooms;

import java.util.ArrayList;
import java.util.List;
import java.util.random.RandomGenerator;
import rsal.data.OccupancyGrid;

/// A floor made of rectangles, whose rooms are known. Later parts are painted over earlier ones.
public final class RandomFloor {
    private static final int WALL = -1;
    private static final double MARGIN = 1; // m, around the floor

    private final double width;
    private final double height;
    private final List<Part> parts = new ArrayList<>();
    private int rooms;

    /// @param room number of a room, [#WALL] or -2 for a door, whose cells belong to no room
    private record Part(double left, double bottom, double right, double top, int room) {
        boolean contains(double x, double y) {
            return x >= left && x < right && y >= bottom && y < top;
        }
    }

    /// A map, and which of its cells are in which room; others have -1 or, in doors, -2.
    public record Painted(OccupancyGrid map, int[] rooms) {}

    /// A floor that is all wall [m].
    public RandomFloor(double width, double height) {
        this.width = width;
        this.height = height;
    }

    public RandomFloor room(double left, double bottom, double right, double top) {
        parts.add(new Part(left, bottom, right, top, rooms++));
        return this;
    }

    public RandomFloor door(double left, double bottom, double right, double top) {
        parts.add(new Part(left, bottom, right, top, -2));
        return this;
    }

    public RandomFloor furniture(double left, double bottom, double right, double top) {
        parts.add(new Part(left, bottom, right, top, WALL));
        return this;
    }

    public int rooms() {
        return rooms;
    }

    /// A corridor with rooms on both sides, 0.2 m walls, doors of 0.8 to 1.2 m.
    public static RandomFloor office(RandomGenerator random) {
        double across = 14 + 20 * random.nextDouble();
        double lower = 3.5 + 3 * random.nextDouble();
        double corridor = 1.8 + 1.2 * random.nextDouble();
        double upper = 3.5 + 3 * random.nextDouble();
        double low = 0.2 + lower;
        var plan = new RandomFloor(across, 0.8 + lower + corridor + upper)
                .room(0.2, low + 0.2, across - 0.2, low + 0.2 + corridor);
        plan.row(random, across, 0.2, low, low, low + 0.2);
        double high = low + 0.2 + corridor;
        plan.row(random, across, high + 0.2, high + 0.2 + upper, high, high + 0.2);
        return plan;
    }

    private void row(
            RandomGenerator random, double across, double bottom, double top, double doorBottom, double doorTop) {
        double left = 0.2;
        while (across - 0.2 - left >= 3) {
            double right = left + 3 + 3 * random.nextDouble();
            right = across - 0.2 - right < 3.2 ? across - 0.2 : right;
            room(left, bottom, right, top);
            double door = 0.8 + 0.4 * random.nextDouble();
            double at = left + 0.3 + (right - left - door - 0.6) * random.nextDouble();
            door(at, doorBottom, at + door, doorTop);
            left = right + 0.2;
        }
    }

    /// Draws it, rotated about its lower left corner.
    ///
    /// @param resolution side of a cell [m]
    /// @param angle counter-clockwise [rad], 0 to π/2
    public Painted paint(double resolution, double angle) {
        double cos = Math.cos(angle);
        double sin = Math.sin(angle);
        int columns = (int) Math.ceil((width * cos + height * sin + 2 * MARGIN) / resolution);
        int rows = (int) Math.ceil((width * sin + height * cos + 2 * MARGIN) / resolution);
        double originX = -height * sin - MARGIN;
        var map = new OccupancyGrid(columns, rows, resolution, originX, -MARGIN, new byte[columns * rows]);
        var roomOf = new int[columns * rows];
        for (int cell = 0; cell < roomOf.length; cell++) {
            double x = map.x(cell % columns);
            double y = map.y(cell / columns);
            roomOf[cell] = at(cos * x + sin * y, cos * y - sin * x);
            map.cells()[cell] = roomOf[cell] == WALL ? OccupancyGrid.OCCUPIED : OccupancyGrid.FREE;
        }
        return new Painted(map, roomOf);
    }

    private int at(double x, double y) {
        int room = WALL;
        for (Part part : parts) {
            room = part.contains(x, y) ? part.room : room;
        }
        return room;
    }
}
