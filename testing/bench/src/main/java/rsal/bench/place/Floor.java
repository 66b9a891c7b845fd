package rsal.bench.place;

import java.util.SplittableRandom;
import rsal.data.OccupancyGrid;

/// A floor like that of a hospital, the same each time: corridors along and across, rooms with a door each between
/// them, and things that stand around.
public final class Floor {
    private static final int CORRIDOR = 60; // cells
    private static final int ROOM = 100; // cells
    private static final int DOOR = 24; // cells
    private static final int BLOCK = 2 * ROOM + CORRIDOR; // two rows of rooms and a corridor
    private static final int THINGS_PER_ROOM = 3;

    private Floor() {}

    /// @param width cells
    /// @param height cells
    /// @param resolution side of a cell [m]
    public static OccupancyGrid draw(int width, int height, double resolution, long seed) {
        var random = new SplittableRandom(seed);
        var cells = new byte[width * height];
        for (int y = 0; y < height; y += BLOCK) {
            for (int x = 0; x < width; x += ROOM) {
                boolean crossing = x / ROOM % 6 == 5; // a corridor across, as wide as a room
                if (!crossing) {
                    room(cells, width, height, x, y + CORRIDOR, true, random);
                    room(cells, width, height, x, y + CORRIDOR + ROOM, false, random);
                }
            }
        }
        frame(cells, width, height);
        return new OccupancyGrid(width, height, resolution, 0, 0, cells);
    }

    /// @param downwards whether its door leads to the corridor below
    private static void room(
            byte[] cells, int width, int height, int x, int y, boolean downwards, SplittableRandom random) {
        for (int i = 0; i <= ROOM; i++) {
            set(cells, width, height, x + i, y);
            set(cells, width, height, x + i, y + ROOM);
            set(cells, width, height, x, y + i);
            set(cells, width, height, x + ROOM, y + i);
        }
        int door = x + DOOR + random.nextInt(ROOM - 3 * DOOR);
        int wall = downwards ? y : y + ROOM;
        for (int i = 0; i < DOOR; i++) {
            if (wall < height && door + i < width) {
                cells[wall * width + door + i] = OccupancyGrid.FREE;
            }
        }
        for (int thing = 0; thing < THINGS_PER_ROOM; thing++) {
            int left = x + 10 + random.nextInt(ROOM - 30);
            int bottom = y + 10 + random.nextInt(ROOM - 30);
            int size = 4 + random.nextInt(10);
            for (int i = 0; i < size * size; i++) {
                set(cells, width, height, left + i % size, bottom + i / size);
            }
        }
    }

    private static void frame(byte[] cells, int width, int height) {
        for (int x = 0; x < width; x++) {
            set(cells, width, height, x, 0);
            set(cells, width, height, x, height - 1);
        }
        for (int y = 0; y < height; y++) {
            set(cells, width, height, 0, y);
            set(cells, width, height, width - 1, y);
        }
    }

    private static void set(byte[] cells, int width, int height, int x, int y) {
        if (x < width && y < height) {
            cells[y * width + x] = OccupancyGrid.OCCUPIED;
        }
    }
}
