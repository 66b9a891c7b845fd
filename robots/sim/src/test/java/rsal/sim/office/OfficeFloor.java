package rsal.sim.office;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.imageio.ImageIO;

/// Draws the built-in map `office`: one floor of an office building, rooms on both sides of a corridor. All measures
/// are in the map frame [m].
///
/// Robots shall not get stuck in it: whatever they can enter is at least 0.8 m wide or so shallow that they need not
/// turn to leave.
public final class OfficeFloor {
    static final double RESOLUTION = 0.05;
    static final double WEST = -31.475;
    static final double SOUTH = -7.8;
    static final double EAST = 31.475;
    static final double NORTH = 7.8;

    private static final int COLUMNS = 1259;
    private static final int ROWS = 312;

    private static final int FLOOR = 254;
    private static final int WALL = 0;
    private static final int WINDOW = 80; // looks lighter than a wall and is as solid
    private static final int FURNITURE = 80;
    private static final int EDGE = 30; // of furniture

    private static final double OUTER = 0.2; // thickness of walls
    private static final double INNER = 0.1;
    private static final double CORRIDOR_NORTH = 0.4;
    private static final double CORRIDOR_SOUTH = -2.4;
    private static final double CORRIDOR_WALL = 0.15;
    private static final double NORTH_ROOMS = CORRIDOR_NORTH + CORRIDOR_WALL; // where they begin
    private static final double SOUTH_ROOMS = CORRIDOR_SOUTH - CORRIDOR_WALL;
    private static final double NORTH_WINDOWS = NORTH - OUTER; // where rooms end
    private static final double SOUTH_WINDOWS = SOUTH + OUTER;

    static final double[] NORTH_DIVISIONS = {-27.1, -16.8, -14.1, -6.2, -0.8, 1.8, 11.1, 15.0, 20.4};
    static final double[] SOUTH_DIVISIONS = {
        -26.0, -22.05, -19.4, -16.75, -14.1, -11.45, -8.8, -6.15, -3.5, 1.8, 7.1, 12.4, 17.7, 23.0, 25.65
    };
    static final double[] PILLARS = {-23.85, -18.55, -13.25, -7.95, -2.65, 2.65, 7.95, 13.6, 18.6, 23.9};

    private static final double PILLAR_LENGTH = 2.5;
    private static final double PILLAR_DEPTH = 0.8;
    private static final double DESK_LENGTH = 1.6;
    private static final double DESK_DEPTH = 0.8;
    private static final double CHAIR = 0.45;
    private static final double CUPBOARD = 0.4; // its depth
    private static final double LANDING = -4.6; // where stairs begin

    private final BufferedImage image = new BufferedImage(COLUMNS, ROWS, BufferedImage.TYPE_BYTE_GRAY);

    private OfficeFloor() {}

    /// A place with a door.
    record Room(String name, double west, double south, double east, double north) {}

    static List<Room> rooms() {
        var rooms = new ArrayList<Room>();
        addRooms(rooms, "north", NORTH_DIVISIONS, NORTH_ROOMS, NORTH_WINDOWS);
        addRooms(rooms, "south", SOUTH_DIVISIONS, SOUTH_WINDOWS, SOUTH_ROOMS);
        return rooms;
    }

    private static void addRooms(List<Room> rooms, String side, double[] divisions, double south, double north) {
        double west = WEST + OUTER;
        for (int i = 0; i <= divisions.length; i++) {
            double east = i < divisions.length ? divisions[i] : EAST - OUTER;
            rooms.add(new Room(side + " " + (i + 1), west, south, east, north));
            west = east;
        }
    }

    /// Writes `office.png` and `office.yaml` into a folder.
    public static void main(String[] arguments) throws IOException {
        Path folder = Path.of(arguments[0]);
        ImageIO.write(draw(), "png", folder.resolve("office.png").toFile());
        Files.writeString(folder.resolve("office.yaml"), yaml());
    }

    static String yaml() {
        return """
                # One floor of an office building, drawn by rsal.sim.office.OfficeFloor.
                image: office.png
                resolution: %s
                origin: [%s, %s, 0]
                negate: 0
                occupied_thresh: 0.65
                free_thresh: 0.196
                """.formatted(RESOLUTION, WEST, SOUTH);
    }

    static BufferedImage draw() {
        var floor = new OfficeFloor();
        floor.fill(WEST, SOUTH, EAST, NORTH, FLOOR);
        floor.outerWalls();
        floor.corridor();
        floor.northRooms();
        floor.southRooms();
        return floor.image;
    }

    private void outerWalls() {
        wall(WEST, SOUTH, EAST, SOUTH_WINDOWS);
        wall(WEST, NORTH_WINDOWS, EAST, NORTH);
        wall(WEST, SOUTH, WEST + OUTER, NORTH);
        wall(EAST - OUTER, SOUTH, EAST, NORTH);
        for (double x = WEST + 0.9; x + 1.8 < EAST; x += 2.65) {
            fill(x, SOUTH + 0.05, x + 1.8, SOUTH + 0.15, WINDOW);
            fill(x, NORTH - 0.15, x + 1.8, NORTH - 0.05, WINDOW);
        }
        fill(WEST + 0.05, -1.9, WEST + 0.15, -0.1, WINDOW);
        fill(EAST - 0.15, -1.9, EAST - 0.05, -0.1, WINDOW);
    }

    private void corridor() {
        wall(WEST, CORRIDOR_NORTH, EAST, NORTH_ROOMS);
        wall(WEST, SOUTH_ROOMS, EAST, CORRIDOR_SOUTH);
        for (double middle : PILLARS) {
            wall(middle - PILLAR_LENGTH / 2, CORRIDOR_NORTH - PILLAR_DEPTH, middle + PILLAR_LENGTH / 2, CORRIDOR_NORTH);
        }
    }

    private void northRooms() {
        for (double x : NORTH_DIVISIONS) {
            wall(x - INNER / 2, NORTH_ROOMS, x + INNER / 2, NORTH_WINDOWS);
        }
        northDoor(-29.2, 1.2); // archive
        cupboard(WEST + OUTER, 2.2, CUPBOARD, 4.6);
        deskBelowWindow(-29.2);

        lab();

        northDoor(-15.6, 1.0); // store
        cupboard(-16.75, 3.8, CUPBOARD, 3.8);
        cupboard(-14.55, 5.6, CUPBOARD, 2.0);

        northDoor(-10.6, 1.2); // four desks
        deskOnWestWall(-14.05, 2.6);
        deskOnWestWall(-14.05, 4.2);
        deskOnEastWall(-6.25, 2.6);
        deskOnEastWall(-6.25, 4.2);
        cupboard(-12.2, 7.2, 4.0, CUPBOARD);
        furniture(-10.9, 3.6, 1.6, 1.0);

        northDoor(-4.9, 1.1); // two desks
        pairOfDesks(-3.3);
        cupboard(-6.15, 2.2, CUPBOARD, 3.0);
        cupboard(-1.25, 3.6, CUPBOARD, 2.4);

        northDoor(0.45, 1.0); // kitchen
        innerDoor(-0.8, 2.0, 1.0);
        furniture(-0.75, 7.0, 2.5, 0.6);
        furniture(1.15, 4.4, 0.6, 2.6);

        seminarRoom();

        northDoor(11.75, 0.95); // one desk
        deskOnWestWall(11.15, 4.6);
        cupboard(12.4, 7.2, 2.55, CUPBOARD);

        northDoor(16.2, 1.2); // two desks
        innerDoor(15.0, 3.2, 1.0);
        pairOfDesks(18.1);
        cupboard(19.95, 2.0, CUPBOARD, 3.4);

        openPlan();
    }

    private void lab() {
        northDoor(-26.1, 1.4);
        northDoor(-21.2, 1.4);
        innerDoor(-16.8, 2.2, 1.0);
        for (double x = -25.2; x < -20; x += DESK_LENGTH) {
            deskBelowWindow(x);
        }
        cupboard(-27.05, 2.4, CUPBOARD, 3.2);
        cupboard(-17.25, 3.6, CUPBOARD, 3.0);
        furniture(-24.6, NORTH_ROOMS, 2.0, 0.6); // work bench
        cupboard(-19.9, NORTH_ROOMS, 2.0, CUPBOARD);
        furniture(-23.2, 3.2, 2.4, 1.2); // robots are built on it
        chair(-22.6, 4.4);
        chair(-21.8, 4.4);
        chair(-22.6, 2.75);
        chair(-21.8, 2.75);
    }

    private void seminarRoom() {
        northDoor(5.3, 1.2);
        northDoor(10.2, 1.2);
        furniture(4.2, 3.6, 4.0, 1.4);
        for (double x = 4.4; x < 8; x += 0.8) {
            chair(x, 5.0);
            chair(x, 3.15);
        }
        chair(3.75, 4.1);
        cupboard(10.65, 3.0, CUPBOARD, 3.6);
        furniture(1.85, 3.2, 0.15, 2.4); // board
    }

    private void openPlan() {
        northDoor(21.5, 1.2);
        northDoor(27.6, 1.4);
        island(23.9, 3.2);
        island(27.3, 3.2);
        cupboard(20.45, 2.6, CUPBOARD, 3.8);
        cupboard(EAST - OUTER - CUPBOARD, 2.0, CUPBOARD, 4.6);
        cupboard(24.0, 7.2, 4.6, CUPBOARD);
    }

    private void southRooms() {
        for (double x : SOUTH_DIVISIONS) {
            wall(x - INNER / 2, SOUTH_WINDOWS, x + INNER / 2, SOUTH_ROOMS);
        }
        southDoor(-28.0, 1.2); // two desks
        deskOnWestWall(WEST + OUTER, -6.6);
        deskOnEastWall(-26.05, -6.6);
        cupboard(-30.0, SOUTH_ROOMS - CUPBOARD, 1.2, CUPBOARD);

        southDoor(-24.0, 1.1); // one desk
        deskOnWestWall(-25.95, -6.4);
        cupboard(-22.5, -6.0, CUPBOARD, 2.4);

        southDoor(-20.7, 1.0); // copier
        innerDoor(-22.05, -3.6, 0.9);
        furniture(-20.2, SOUTH_WINDOWS, 0.75, 0.9);
        cupboard(-22.0, SOUTH_WINDOWS, 1.0, CUPBOARD);

        southDoor(-18.1, 1.4);
        stairs(-19.35, -16.8);

        southDoor(-15.4, 1.0);
        smallOffice(-16.7, true);

        for (int i = 0; i < 4; i++) {
            double west = -14.05 + i * 2.65;
            southDoor(west + 1.25, 1.0);
            smallOffice(west, i % 2 == 0);
        }

        for (int i = 0; i < 5; i++) {
            double west = -3.45 + i * 5.3;
            southDoor(west + (i % 2 == 0 ? 1.6 : 3.6), 1.1);
            deskOnWestWall(west, -6.4);
            deskOnEastWall(west + 5.2, -6.4);
            cupboard(west + 1.8, SOUTH_WINDOWS, 1.6, CUPBOARD);
        }
        innerDoor(1.8, -3.8, 1.0);
        innerDoor(12.4, -3.8, 1.0);

        southDoor(24.3, 1.0);
        smallOffice(23.05, false);

        southDoor(27.0, 1.4);
        stairs(25.7, 28.3);
        lift(28.3);
    }

    /// A desk at the window and a cupboard at the wall across.
    private void smallOffice(double west, boolean cupboardInTheWest) {
        double east = west + 2.55;
        furniture(cupboardInTheWest ? east - DESK_LENGTH : west, SOUTH_WINDOWS, DESK_LENGTH, DESK_DEPTH);
        chair(cupboardInTheWest ? east - 1.4 : west + 1.4 - CHAIR, SOUTH_WINDOWS + DESK_DEPTH);
        cupboard(cupboardInTheWest ? west : east - CUPBOARD, -5.6, CUPBOARD, 1.6);
    }

    /// Two flights, one up and one down, behind a landing.
    private void stairs(double west, double east) {
        double middle = (west + east) / 2;
        wall(middle - INNER / 2, SOUTH_WINDOWS, middle + INNER / 2, LANDING);
        for (double y = LANDING - RESOLUTION; y > SOUTH_WINDOWS + 0.5; y -= 0.3) {
            fill(west, y, east, y + RESOLUTION, EDGE);
        }
    }

    /// A shaft in the corner of the building, with the cabin in it.
    private void lift(double west) {
        wall(west, SOUTH_WINDOWS, EAST - OUTER, LANDING);
        fill(west + 0.2, SOUTH_WINDOWS + 0.1, EAST - OUTER - 0.1, LANDING - 0.2, FURNITURE);
        fill(west + 0.8, LANDING - 0.1, EAST - OUTER - 0.8, LANDING - 0.05, FURNITURE); // its closed door
    }

    /// Two desks face to face below the north windows, with a chair each.
    private void pairOfDesks(double middle) {
        furniture(middle - DESK_DEPTH, NORTH_WINDOWS - DESK_LENGTH, 2 * DESK_DEPTH, DESK_LENGTH);
        chair(middle - DESK_DEPTH - CHAIR, NORTH_WINDOWS - 0.6);
        chair(middle + DESK_DEPTH, NORTH_WINDOWS - 0.6);
    }

    /// Two desks face to face in the middle of a room.
    private void island(double west, double south) {
        furniture(west, south, DESK_LENGTH, 2 * DESK_DEPTH);
        chair(west + 0.6, south - CHAIR);
        chair(west + 0.6, south + 2 * DESK_DEPTH);
    }

    private void deskBelowWindow(double middle) {
        furniture(middle - DESK_LENGTH / 2, NORTH_WINDOWS - DESK_DEPTH, DESK_LENGTH, DESK_DEPTH);
        chair(middle - CHAIR / 2, NORTH_WINDOWS - DESK_DEPTH - CHAIR);
    }

    private void deskOnWestWall(double wall, double south) {
        furniture(wall, south, DESK_DEPTH, DESK_LENGTH);
        chair(wall + DESK_DEPTH, south + 0.55);
    }

    private void deskOnEastWall(double wall, double south) {
        furniture(wall - DESK_DEPTH, south, DESK_DEPTH, DESK_LENGTH);
        chair(wall - DESK_DEPTH - CHAIR, south + 0.55);
    }

    private void chair(double west, double south) {
        furniture(west, south, CHAIR, CHAIR);
    }

    private void cupboard(double west, double south, double length, double depth) {
        furniture(west, south, length, depth);
    }

    private void northDoor(double middle, double width) {
        fill(middle - width / 2, CORRIDOR_NORTH, middle + width / 2, NORTH_ROOMS, FLOOR);
    }

    private void southDoor(double middle, double width) {
        fill(middle - width / 2, SOUTH_ROOMS, middle + width / 2, CORRIDOR_SOUTH, FLOOR);
    }

    /// A door in a wall between two rooms of a side.
    private void innerDoor(double wall, double middle, double width) {
        fill(wall - INNER / 2, middle - width / 2, wall + INNER / 2, middle + width / 2, FLOOR);
    }

    private void wall(double west, double south, double east, double north) {
        fill(west, south, east, north, WALL);
    }

    private void furniture(double west, double south, double length, double depth) {
        fill(west, south, west + length, south + depth, EDGE);
        fill(west + RESOLUTION, south + RESOLUTION, west + length - RESOLUTION, south + depth - RESOLUTION, FURNITURE);
    }

    /// Paints all cells between two corners, which go to the nearest cell borders.
    private void fill(double west, double south, double east, double north, int shade) {
        int lastRow = row(north);
        int lastColumn = column(east);
        for (int row = row(south); row < lastRow; row++) {
            for (int column = column(west); column < lastColumn; column++) {
                image.getRaster().setSample(column, ROWS - 1 - row, 0, shade);
            }
        }
    }

    private static int column(double x) {
        return (int) Math.round((x - WEST) / RESOLUTION - 1e-6);
    }

    private static int row(double y) {
        return (int) Math.round((y - SOUTH) / RESOLUTION - 1e-6);
    }
}
