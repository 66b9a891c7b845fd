package rsal.scenario.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Prism;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.scene.Block;
import rsal.scene.Entity;
import rsal.scene.Raster;
import rsal.scene.Scene;
import rsal.scene.Surface;
import rsal.scene.Touch;

/// Pictures of a hall of 4 m × 4 m with a single cell of wall, 1 m × 1 m × 0.6 m, at its middle.
class WorldPictureTest {
    private static final int WALL = 0x333333;
    private static final Rgb GREEN = Rgb.of(0x00ff00);
    private static final Rgb RED = Rgb.of(0xff0000);

    @Test
    void showsWallsOverWhatLiesFlatUnderThem() throws IOException {
        var picture = picture(box("zone", 3, 0, 0.02, GREEN));

        assertThat(colorAt(picture, 2, 2)).isEqualTo(WALL);
        assertThat(colorAt(picture, 1, 1)).isEqualTo(GREEN.packed());
    }

    @Test
    void showsWhatIsHigherThanAWallOverIt() throws IOException {
        var picture = picture(box("tower", 3, 0, 0.8, GREEN));

        assertThat(colorAt(picture, 2, 2)).isEqualTo(GREEN.packed());
    }

    @Test
    void showsTheHigherOfTwoThingsWhicheverComesFirst() throws IOException {
        Entity board = box("board", 3, 0.7, 0.1, RED); // up at 0.7 m
        Entity tower = box("tower", 3, 0, 0.75, GREEN);

        assertThat(colorAt(picture(board, tower), 2, 2)).isEqualTo(RED.packed());
        assertThat(colorAt(picture(tower, board), 2, 2)).isEqualTo(RED.packed());
    }

    private static Entity box(String name, double side, double height, double thick, Rgb color) {
        Shape square = new Shape.Polygon(List.of(
                new Point2d(-side / 2, -side / 2),
                new Point2d(side / 2, -side / 2),
                new Point2d(side / 2, side / 2),
                new Point2d(-side / 2, side / 2)));
        var block = new Block(Prism.standing(square, thick), Surface.PLAIN.in(color));
        return new Entity(name, List.of(block), new Pose2d(2, 2, 0), height);
    }

    private static BufferedImage picture(Entity... things) throws IOException {
        var cell = new BitSet();
        cell.set(0);
        var wall = new Raster(1, 1, cell, 1.5, 1.5, 1, 1, 0, 0.6, false, Surface.PLAIN);
        var scene = new Scene(
                "",
                new OccupancyGrid(40, 40, 0.1, 0, 0, new byte[1600]),
                Optional.empty(),
                Optional.empty(),
                Touch.STALL,
                List.of(wall),
                List.of(things),
                List.of(),
                Map.of(),
                Map.of(),
                Map.of(),
                Collections.emptySortedMap(),
                List.of(),
                List.of());
        return ImageIO.read(new ByteArrayInputStream(WorldPicture.of(scene, 400)));
    }

    private static int colorAt(BufferedImage picture, double x, double y) {
        return picture.getRGB((int) (100 * x), (int) (100 * (4 - y))) & 0xffffff;
    }
}
