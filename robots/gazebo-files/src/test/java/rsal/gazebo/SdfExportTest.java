package rsal.gazebo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Prism;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.model.RobotModels;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotModel.Steering;
import rsal.robot.RobotSpec;
import rsal.scene.Block;
import rsal.scene.Entity;
import rsal.scene.Scene;
import rsal.scene.SolidRaster;
import rsal.scene.Surface;
import rsal.scene.Touch;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.testkit.Rounds;
import rsal.world.SceneExport;
import rsal.world.SceneExport.Exported;

class SdfExportTest {
    private static final double CELL = 0.05; // [m]

    private static Scene scene(List<SolidRaster> walls, List<Entity> things, List<RobotSpec> robots) {
        return new Scene(
                "Yard & <garden>",
                new OccupancyGrid(10, 10, 1, -5, -5, new byte[100]),
                Optional.empty(),
                Optional.empty(),
                Touch.STALL,
                walls,
                things,
                robots,
                Map.of(),
                Map.of(),
                Map.of(),
                Collections.emptySortedMap(),
                List.of(),
                List.of());
    }

    private static Exported written(Scene scene) {
        return SceneExport.of("test.sdf").orElseThrow().write(scene, "test", Location.of("test.world"));
    }

    private static Scene read(Exported written) {
        return new Worlds()
                .and("worlds/test.sdf", written.files().get("test.sdf"))
                .read();
    }

    private static Scene roundTrip(Scene scene) {
        return read(written(scene));
    }

    private static Block block(Shape shape, double bottom, double top, int color) {
        return new Block(new Prism(shape, bottom, top, Optional.empty()), Surface.PLAIN.in(Rgb.of(color)));
    }

    /// A star around the middle, with as many points as corners.
    private static Shape star(Random random) {
        int corners = 3 + random.nextInt(8);
        var outline = new ArrayList<Point2d>();
        for (int i = 0; i < corners; i++) {
            Pose2d corner = Pose2d.polar(0.2 + random.nextDouble(), 2 * Math.PI * i / corners);
            outline.add(new Point2d(corner.x() + 0.3, corner.y() - 0.2));
        }
        return new Shape.Polygon(outline);
    }

    private static Entity thing(String name, Random random) {
        var blocks = new ArrayList<Block>();
        for (int i = random.nextInt(3); i >= 0; i--) {
            double x = random.nextGaussian();
            double y = random.nextGaussian();
            Shape shape = switch (random.nextInt(3)) {
                case 0 -> new Shape.Disc(new Point2d(x, y), 0.05 + random.nextDouble());
                case 1 ->
                    Shape.Polygon.of(rsal.data.Footprint.box(
                            0.1 + random.nextDouble(), 0.1 + random.nextDouble(), new Point2d(x, y)));
                default -> star(random);
            };
            double bottom = random.nextInt(3) * 0.2;
            blocks.add(block(shape, bottom, bottom + 0.1 + random.nextDouble(), random.nextInt(1 << 24)));
        }
        var pose = new Pose2d(
                4 * random.nextGaussian(), 4 * random.nextGaussian(), 2 * Math.PI * random.nextDouble() - Math.PI);
        return new Entity(name, blocks, pose, random.nextInt(3) * 0.5);
    }

    private static SolidRaster walls(Random random) {
        int width = 5 + random.nextInt(30);
        int height = 5 + random.nextInt(30);
        var solid = new BitSet();
        for (int i = 0; i < 8; i++) {
            int left = random.nextInt(width);
            int low = random.nextInt(height);
            for (int row = low; row < Math.min(height, low + 1 + random.nextInt(9)); row++) {
                solid.set(row * width + left, row * width + Math.min(width, left + 1 + random.nextInt(9)));
            }
        }
        return new SolidRaster(
                width,
                height,
                solid,
                random.nextGaussian(),
                random.nextGaussian(),
                0.1,
                0.2,
                0,
                1.5,
                false,
                Surface.PLAIN);
    }

    private static boolean covers(SolidRaster walls, double x, double y) {
        int column = (int) Math.floor((x - walls.left()) / walls.cellX());
        int row = (int) Math.floor((y - walls.bottom()) / walls.cellY());
        return column >= 0
                && row >= 0
                && column < walls.width()
                && row < walls.height()
                && walls.solid().get(row * walls.width() + column);
    }

    private static boolean covers(Scene scene, double x, double y) {
        return scene.walls().stream().anyMatch(walls -> covers(walls, x, y))
                || scene.things().stream().anyMatch(thing -> Worlds.covers(thing, x, y));
    }

    /// Whether it is the same on all sides of a point, so that rounding does not count.
    private static boolean isClear(Scene scene, double x, double y, boolean covered) {
        double hair = 1e-6;
        return covers(scene, x + hair, y) == covered
                && covers(scene, x - hair, y) == covered
                && covers(scene, x, y + hair) == covered
                && covers(scene, x, y - hair) == covered;
    }

    @Test
    void whatIsReadAgainCoversTheSameFloor() {
        for (long seed = 0; seed < Rounds.of(33, 10_000); seed++) {
            var random = new Random(seed);
            var things = new ArrayList<Entity>();
            for (int i = random.nextInt(5); i >= 0; i--) {
                things.add(thing("thing " + i, random));
            }
            Scene scene = scene(List.of(walls(random)), things, List.of());
            Scene again = roundTrip(scene);
            assertThat(again.warnings()).as("seed " + seed).isEmpty();
            for (int i = 0; i < 500; i++) {
                double x = 12 * random.nextDouble() - 6;
                double y = 12 * random.nextDouble() - 6;
                boolean covered = covers(scene, x, y);
                if (isClear(scene, x, y, covered)) {
                    assertThat(covers(again, x, y))
                            .as("seed %d at %s, %s", seed, x, y)
                            .isEqualTo(covered);
                }
            }
        }
    }

    @Test
    void heightsAndColorsStay() {
        for (long seed = 0; seed < 50; seed++) {
            Entity thing = thing("a", new Random(seed));
            Entity again = roundTrip(scene(List.of(), List.of(thing), List.of()))
                    .things()
                    .getFirst();
            assertThat(again.name()).isEqualTo("a");
            assertThat(again.height()).isEqualTo(thing.height());
            assertThat(again.mapFromEntity().theta())
                    .isCloseTo(thing.mapFromEntity().theta(), within(1e-6));
            assertThat(again.blocks()).hasSameSizeAs(thing.blocks());
            for (int i = 0; i < thing.blocks().size(); i++) {
                Prism before = thing.blocks().get(i).prism();
                Prism after = again.blocks().get(i).prism();
                assertThat(after.bottom()).isCloseTo(before.bottom(), within(1e-6));
                assertThat(after.top()).isCloseTo(before.top(), within(1e-6));
                assertThat(again.blocks().get(i).surface().color())
                        .isEqualTo(thing.blocks().get(i).surface().color());
            }
        }
    }

    @Test
    void whatIsSolidOnlyInTheMapIsTwoMetersHigh() {
        OccupancyGrid map =
                new OccupancyGrid(2, 1, CELL, 0, 0, new byte[] {OccupancyGrid.OCCUPIED, OccupancyGrid.FREE});
        Exported written = written(Scene.of(map));
        assertThat(written.notes()).containsExactly("Walls of maps have no height; they are written 2 m high.");
        assertThat(written.files()).containsOnlyKeys("test.sdf"); // no robots, no bridge
        assertThat(read(written).things().getFirst().blocks().getFirst().prism().top())
                .isEqualTo(2);
        assertThat(read(written).things().getFirst().height()).isZero();
    }

    @Test
    void whatRobotsPassThroughIsOnlySeen() {
        Surface surface = new Surface(new Rgb(1, 2, 3), false, 1, true, 7, 0, false);
        var carpet = new Entity(
                "carpet::red",
                List.of(new Block(Prism.standing(new Shape.Disc(new Point2d(0, 0), 1), 0.01), surface)),
                Pose2d.ORIGIN,
                0);
        Exported written = written(scene(List.of(), List.of(carpet, carpet), List.of()));
        Scene again = read(written);
        assertThat(again.things()).extracting(Entity::name).containsExactly("carpet_red", "carpet_red_2");
        assertThat(again.things().getFirst().blocks().getFirst().surface().obstacle())
                .isFalse();
        assertThat(written.notes()).containsExactly("Markers are not written: Gazebo has none.");
    }

    private static RobotSpec robot(String id, String model, Pose2d pose) {
        RobotModel read = new RobotModels(FileSource.disk()).read(model, Location.of(model));
        return new RobotSpec(id, "guard", read, Optional.of(pose), "#d55e00");
    }

    @Test
    void allRobotModelsAreRobotsAgain() {
        for (String model : RobotModels.builtIn()) {
            var pose = new Pose2d(1, 2, 0.5);
            RobotSpec robot = robot("r-1", model, pose);
            Scene again = roundTrip(scene(List.of(), List.of(), List.of(robot)));
            assertThat(again.robots()).as(model).hasSize(1);
            assertThat(again.things()).as(model).isEmpty();
            RobotSpec read = again.robots().getFirst();
            assertThat(read.mapFromBase().orElseThrow().x()).as(model).isCloseTo(1, within(1e-6));
            assertThat(read.mapFromBase().orElseThrow().theta()).as(model).isCloseTo(0.5, within(1e-6));
            sameOutline(model, robot.model(), read.model());
            assertThat(read.model().drive().forward())
                    .as(model)
                    .isEqualTo(robot.model().drive().forward());
            assertThat(read.model().drive().maxTurnRate())
                    .as(model)
                    .isCloseTo(robot.model().drive().maxTurnRate(), within(1e-6));
            boolean differential = robot.model().drive().steering() instanceof Steering.Differential;
            assertThat(read.model().drive().steering())
                    .as(model)
                    .isEqualTo(differential ? new Steering.Differential() : new Steering.Omnidirectional());
        }
    }

    /// Wheels are inside of it.
    private static void sameOutline(String which, RobotModel before, RobotModel after) {
        for (int i = 0; i < 36; i++) {
            Pose2d direction = Pose2d.polar(1, 2 * Math.PI * i / 36);
            assertThat(reach(after, direction)).as(which).isCloseTo(reach(before, direction), within(1e-6));
        }
    }

    private static double reach(RobotModel model, Pose2d direction) {
        return model.footprint().corners().stream()
                .mapToDouble(corner -> corner.x() * direction.x() + corner.y() * direction.y())
                .max()
                .orElseThrow();
    }

    @Test
    void lasersStay() {
        RobotSpec robot = robot("r", "jackal", Pose2d.ORIGIN);
        var before = (Part.Laser) robot.model().sensors().get("laser");
        var after = (Part.Laser) roundTrip(scene(List.of(), List.of(), List.of(robot)))
                .robots()
                .getFirst()
                .model()
                .sensors()
                .get("laser");
        assertThat(after.samples()).isEqualTo(before.samples());
        assertThat(after.angleMin()).isCloseTo(before.angleMin(), within(1e-6));
        assertThat(after.angleIncrement()).isCloseTo(before.angleIncrement(), within(1e-6));
        assertThat(after.rangeMax()).isEqualTo(before.rangeMax());
        assertThat(after.period()).isEqualTo(before.period());
        assertThat(after.baseFromLaser().x()).isCloseTo(before.baseFromLaser().x(), within(1e-6));
    }

    @Test
    void theBridgeNamesTheTopicsOfEachRobot() {
        Exported written = written(scene(
                List.of(),
                List.of(),
                List.of(robot("hunter-1", "jackal", Pose2d.ORIGIN), robot("2", "robotino", new Pose2d(2, 0, 0)))));
        String bridge = new String(written.files().get("test.bridge.yaml"), StandardCharsets.UTF_8);
        String sdf = new String(written.files().get("test.sdf"), StandardCharsets.UTF_8);
        for (String topic : List.of("cmd_vel", "odom", "tf", "scan")) {
            assertThat(bridge).contains("ros_topic_name: \"/hunter_1/%s\"".formatted(topic));
            assertThat(bridge).contains("ros_topic_name: \"/_2/%s\"".formatted(topic));
            assertThat(bridge).contains("gz_topic_name: \"/model/hunter_1/%s\"".formatted(topic));
            assertThat(sdf).contains("topic>/model/hunter_1/%s</".formatted(topic));
        }
        assertThat(bridge).contains("\"/clock\"").contains("direction: ROS_TO_GZ");
        assertThat(written.notes())
                .containsExactly("Of devices only lasers are written, not sonars, cameras, grippers and others.");
    }

    @Test
    void whatNeedsTooManyBoxesIsRefused() {
        var board = new BitSet();
        for (int cell = 0; cell < 301 * 300; cell += 2) {
            board.set(cell);
        }
        var walls = new SolidRaster(301, 300, board, 0, 0, 0.1, 0.1, 0, 1, false, Surface.PLAIN);
        assertThatThrownBy(() -> written(scene(List.of(walls), List.of(), List.of())))
                .isInstanceOf(InvalidSettings.class)
                .hasMessageContaining("take more than 20000 boxes");
    }
}
