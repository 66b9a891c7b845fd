package rsal.scenario.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
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
import rsal.scene.Scene;
import rsal.scene.SolidRaster;
import rsal.scene.Surface;
import rsal.scene.Touch;
import rsal.world.yaml.YamlFormat;

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

    @Test
    void fansEndWhereTheSensorsRaysEnd() throws IOException {
        var scene = world("""
                rsal: 1
                area: [0, 0, 5, 5]
                walls: [{line: [[0, 1.4], [4, 1.4]], height: 0.1}, {image: wall.pgm, resolution: 0.2, origin: [2, 4, 0]}]
                things:
                  can: {pose: [2.5, 2.5, 0], body: {radius: 0.3}, grippable: true}
                  glass: {pose: [2, 2, 0], body: {length: 0.2, width: 0.2}, reflectance: -1}
                  board: {pose: [2, 1, 0], body: {length: 0.2, width: 0.2, bottom: 0.5, height: 0.1}}
                robots:
                  seer: {model: cart, pose: [1, 2.5, 0], devices: {laser: eye}}
                  other: {model: cart, pose: [1.75, 3.25, 0]}
                models:
                  cart:
                    body: {radius: 0.1, height: 0.4}
                    drive:
                      maxSpeed: 1
                      maxTurnRate: 90
                      maxAcceleration: 1
                      maxTurnAcceleration: 90
                      odometryNoise: {distancePerMeter: 0, headingPerMeter: 0, headingPerDegree: 0}
                    mounts: {laser: [0, 0, 0]}
                parts: {eye: {type: laser, fieldOfView: 200, samples: 401, range: [0, 3.5], noise: 0, period: 0.1}}
                """);
        var picture = ImageIO.read(new ByteArrayInputStream(WorldPicture.of(scene, 1000)));
        assertThat(isSeen(picture, scene, 1.8, 2.5)).as("before the can").isTrue();
        assertThat(isSeen(picture, scene, 3.2, 2.5)).as("behind the can").isFalse();
        assertThat(isSeen(picture, scene, 2.4, 3.9))
                .as("behind the other robot")
                .isFalse();
        assertThat(isSeen(picture, scene, 2.7, 1.65))
                .as("behind what rangers look through")
                .isTrue();
        assertThat(isSeen(picture, scene, 2.5, 0.25))
                .as("behind a low wall, under a board")
                .isTrue();
        assertThat(isSeen(picture, scene, 1, 3.2)).as("aside").isTrue();
        assertThat(isSeen(picture, scene, 1.9, 4.2)).as("beside the image").isTrue();
        assertThat(isSeen(picture, scene, 2.4, 4.8)).as("behind the image").isFalse();
        assertThat(isSeen(picture, scene, 4.3, 1.5)).as("at its range").isTrue();
        assertThat(isSeen(picture, scene, 4.6, 1.41)).as("beyond its range").isFalse();
        assertThat(isSeen(picture, scene, 0.7, 2.5)).as("behind its back").isFalse();
    }

    private static Scene world(String text) {
        return new YamlFormat()
                .read(
                        "hall.world.yaml",
                        (path, _, _) ->
                                (path.equals("wall.pgm") ? "P1 2 1 1 1" : text).getBytes(StandardCharsets.US_ASCII),
                        1);
    }

    /// Whether a fan is drawn over the white of the floor.
    private static boolean isSeen(BufferedImage picture, Scene scene, double x, double y) {
        OccupancyGrid map = scene.map();
        double perMeter = picture.getWidth() / (map.width() * map.resolution());
        int column = (int) ((x - map.originX()) * perMeter);
        int row = (int) ((map.originY() + map.height() * map.resolution() - y) * perMeter);
        return (picture.getRGB(column, row) & 0xff0000) < 0xff0000;
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
        var wall = new SolidRaster(1, 1, cell, 1.5, 1.5, 1, 1, 0, 0.6, false, Surface.PLAIN);
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
