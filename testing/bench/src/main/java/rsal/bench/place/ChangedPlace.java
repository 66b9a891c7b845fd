package rsal.bench.place;

import java.util.ArrayList;
import java.util.List;
import java.util.random.RandomGenerator;
import rsal.data.OccupancyGrid;

/// Places that differ from their maps: furniture that was moved or added, walls that were drawn at the wrong place. All
/// methods return a new map of the same size; the same random numbers give the same map.
public final class ChangedPlace {
    private static final int TRIES = 400;
    private static final double AISLE = 0.7; // [m] that is left free around furniture

    private ChangedPlace() {}

    /// A piece of furniture.
    ///
    /// @param column of its lower left corner
    /// @param row the same
    /// @param width cells
    /// @param height cells
    public record Piece(int column, int row, int width, int height) {}

    /// Pieces of 0.3 to 1.4 m on free floor. A half of them stands at walls, the others have an aisle around them, so
    /// that robots still get to all rooms.
    public static List<Piece> furniture(OccupancyGrid map, int count, RandomGenerator random) {
        var pieces = new ArrayList<Piece>();
        var taken = map.cells().clone();
        for (int i = 0; i < count; i++) {
            boolean atWall = i % 2 == 0;
            for (int tried = 0; tried < TRIES; tried++) {
                Piece piece = piece(map, random);
                int aisle = (int) (AISLE / map.resolution());
                if (isFree(map, taken, piece, 0)
                        && (atWall
                                ? isBacked(map, piece) && hasFreeSide(map, taken, piece, aisle)
                                : isFree(map, taken, piece, aisle))) {
                    pieces.add(piece);
                    fill(map, taken, piece);
                    break;
                }
            }
        }
        return pieces;
    }

    private static Piece piece(OccupancyGrid map, RandomGenerator random) {
        int width = (int) (random.nextDouble(0.3, 1.4) / map.resolution());
        int height = (int) (random.nextDouble(0.3, 0.8) / map.resolution());
        boolean turned = random.nextBoolean();
        return new Piece(
                random.nextInt(map.width()),
                random.nextInt(map.height()),
                turned ? height : width,
                turned ? width : height);
    }

    private static boolean isFree(OccupancyGrid map, byte[] cells, Piece piece, int around) {
        for (int row = piece.row - around; row < piece.row + piece.height + around; row++) {
            for (int column = piece.column - around; column < piece.column + piece.width + around; column++) {
                if (row < 0
                        || column < 0
                        || row >= map.height()
                        || column >= map.width()
                        || cells[row * map.width() + column] != OccupancyGrid.FREE) {
                    return false;
                }
            }
        }
        return true;
    }

    /// Whether a wall is just below it or to its left.
    private static boolean isBacked(OccupancyGrid map, Piece piece) {
        return isFull(map, piece.column, piece.row - 1, piece.width, 1)
                || isFull(map, piece.column - 1, piece.row, 1, piece.height);
    }

    private static boolean isFull(OccupancyGrid map, int left, int bottom, int width, int height) {
        if (left < 0 || bottom < 0) {
            return false;
        }
        for (int row = bottom; row < bottom + height; row++) {
            for (int column = left; column < left + width; column++) {
                if (map.at(column, row) != OccupancyGrid.OCCUPIED) {
                    return false;
                }
            }
        }
        return true;
    }

    private static boolean hasFreeSide(OccupancyGrid map, byte[] cells, Piece piece, int aisle) {
        return isFree(map, cells, new Piece(piece.column, piece.row, piece.width + aisle, piece.height + aisle), 0);
    }

    private static void fill(OccupancyGrid map, byte[] cells, Piece piece) {
        for (int row = piece.row; row < piece.row + piece.height; row++) {
            for (int column = piece.column; column < piece.column + piece.width; column++) {
                cells[row * map.width() + column] = OccupancyGrid.OCCUPIED;
            }
        }
    }

    /// The same with furniture.
    public static OccupancyGrid with(OccupancyGrid map, List<Piece> pieces) {
        var cells = map.cells().clone();
        pieces.forEach(piece -> fill(map, cells, piece));
        return like(map, cells);
    }

    /// Of the walls of a map some are moved by 0.3 to 0.6 m: tiles of 2 m are drawn beside where they are, until this
    /// share of the wall cells is.
    public static OccupancyGrid withWallsMoved(OccupancyGrid map, double share, RandomGenerator random) {
        var cells = map.cells().clone();
        int side = (int) (2 / map.resolution());
        long walls = count(map);
        long moved = 0;
        var done = new boolean[Math.ceilDiv(map.width(), side) * Math.ceilDiv(map.height(), side)];
        for (int tried = 0; moved < share * walls && tried < 100 * done.length; tried++) {
            int column = random.nextInt(Math.ceilDiv(map.width(), side));
            int row = random.nextInt(Math.ceilDiv(map.height(), side));
            int tile = row * Math.ceilDiv(map.width(), side) + column;
            if (!done[tile]) {
                done[tile] = true;
                double by = random.nextDouble(0.3, 0.6) * (random.nextBoolean() ? 1 : -1) / map.resolution();
                boolean along = random.nextBoolean();
                moved += move(map, cells, column * side, row * side, side, along ? (int) by : 0, along ? 0 : (int) by);
            }
        }
        return like(map, cells);
    }

    private static int move(OccupancyGrid map, byte[] cells, int left, int bottom, int side, int dx, int dy) {
        int walls = 0;
        for (int row = bottom; row < Math.min(map.height(), bottom + side); row++) {
            for (int column = left; column < Math.min(map.width(), left + side); column++) {
                int fromColumn = Math.clamp(column - dx, 0, map.width() - 1);
                int fromRow = Math.clamp(row - dy, 0, map.height() - 1);
                walls += map.at(column, row) == OccupancyGrid.OCCUPIED ? 1 : 0;
                cells[row * map.width() + column] = map.at(fromColumn, fromRow);
            }
        }
        return walls;
    }

    private static long count(OccupancyGrid map) {
        long walls = 0;
        for (byte cell : map.cells()) {
            walls += cell == OccupancyGrid.OCCUPIED ? 1 : 0;
        }
        return walls;
    }

    /// A part of the map drawn badly: rotated by `turn` [rad] and enlarged around its middle.
    ///
    /// @param x of its middle [m]
    /// @param y the same
    /// @param radius of the part [m]
    public static OccupancyGrid withBadPart(
            OccupancyGrid map, double x, double y, double radius, double turn, double scale) {
        var cells = map.cells().clone();
        double cos = Math.cos(turn) / scale;
        double sin = Math.sin(turn) / scale;
        for (int row = 0; row < map.height(); row++) {
            for (int column = 0; column < map.width(); column++) {
                double dx = map.x(column) - x;
                double dy = map.y(row) - y;
                if (Math.hypot(dx, dy) < radius) {
                    double fromX = x + cos * dx + sin * dy;
                    double fromY = y - sin * dx + cos * dy;
                    int fromColumn = (int) Math.floor((fromX - map.originX()) / map.resolution());
                    int fromRow = (int) Math.floor((fromY - map.originY()) / map.resolution());
                    cells[row * map.width() + column] = map.at(
                            Math.clamp(fromColumn, 0, map.width() - 1), Math.clamp(fromRow, 0, map.height() - 1));
                }
            }
        }
        return like(map, cells);
    }

    /// A building that half a turn makes the same, 30 m × 14 m: rooms on both sides of a corridor.
    public static OccupancyGrid mirrored() {
        var plan = Floorplan.room(30, 14);
        for (double x : new double[] {6, 11, 18}) {
            plan = plan.with(x - 0.1, 8, x + 0.1, 14).with(30 - x - 0.1, 0, 30 - x + 0.1, 6);
        }
        double[] doors = {2.5, 8.5, 14, 24};
        double from = 0;
        for (double door : doors) {
            plan = plan.with(from, 7.9, door, 8.1).with(30 - door, 5.9, 30 - from, 6.1);
            from = door + 1.2;
        }
        plan = plan.with(from, 7.9, 30, 8.1).with(0, 5.9, 30 - from, 6.1);
        return plan.with(3.5, 11, 4.5, 12)
                .with(25.5, 2, 26.5, 3)
                .with(22, 10, 23.5, 11)
                .with(6.5, 3, 8, 4)
                .grid();
    }

    private static OccupancyGrid like(OccupancyGrid map, byte[] cells) {
        return new OccupancyGrid(map.width(), map.height(), map.resolution(), map.originX(), map.originY(), cells);
    }
}
