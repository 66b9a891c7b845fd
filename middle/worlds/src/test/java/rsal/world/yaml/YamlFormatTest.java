package rsal.world.yaml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.ServiceLoader;
import java.util.function.BiPredicate;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotSpec;
import rsal.scene.Block;
import rsal.scene.Entity;
import rsal.scene.Scene;
import rsal.scene.SolidRaster;
import rsal.scene.Touch;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Problem;
import rsal.world.SceneFormat;

/// What becomes of worlds of our own.
class YamlFormatTest {
    private static final Path DOCS = Path.of("../../docs");

    private static Scene scene(String text) {
        return Worlds.of(text).read();
    }

    private static boolean occupied(Scene scene, double x, double y) {
        OccupancyGrid map = scene.map();
        return map.at(map.column(x), map.row(y)) == OccupancyGrid.OCCUPIED;
    }

    /// Whether a place is in one of a thing's pieces.
    private static boolean holds(Entity thing, double x, double y) {
        Pose2d place = thing.mapFromEntity().inverse().compose(new Pose2d(x, y, 0));
        BiPredicate<Shape, Pose2d> inside = (shape, p) -> switch (shape) {
            case Shape.Disc disc -> disc.center().distanceTo(p.position()) < disc.radius();
            case Shape.Polygon polygon -> {
                boolean in = false;
                List<Point2d> c = polygon.corners();
                for (int i = 0; i < c.size(); i++) {
                    Point2d a = c.get(i);
                    Point2d b = c.get((i + 1) % c.size());
                    if (a.y() > p.y() != b.y() > p.y()
                            && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
                        in = !in;
                    }
                }
                yield in;
            }
        };
        return thing.blocks().stream()
                .anyMatch(block -> inside.test(block.prism().shape(), place));
    }

    @Test
    void theExampleOfThePageIsAWorld() throws IOException {
        String page = Files.readString(DOCS.resolve("reference/worlds.md"));
        String example = Files.readString(DOCS.resolve("examples/yard.world.yaml"));
        assertThat(page).contains("```yaml\n" + example + "```");
        Scene scene = new YamlFormat().read("yard.world.yaml", FileSource.folder(DOCS.resolve("examples")), 1);
        assertThat(scene.warnings()).isEmpty();
        assertThat(scene.title()).isEqualTo("A yard");
        assertThat(scene.step()).contains(Duration.ofMillis(100));
        assertThat(scene.end()).contains(Duration.ofMinutes(5));
        assertThat(scene.contents())
                .containsEntry("rocks", 12)
                .containsEntry("guard", 2)
                .containsEntry("wall", 5);
        assertThat(scene.robots()).extracting(RobotSpec::id).containsExactly("cart", "guard-1", "guard-2", "guest");
        assertThat(scene.robots().getFirst().model().sensors().values())
                .hasAtLeastOneElementOfType(Part.Gripper.class)
                .hasAtLeastOneElementOfType(Part.Laser.class);
    }

    @Test
    void everyKeyOfAThingIsOnThePage() throws IOException {
        String page = Files.readString(DOCS.resolve("reference/worlds.md"));
        assertThat(Keys.SURFACE).allSatisfy(key -> assertThat(page).contains("| `" + key.name() + "` |"));
    }

    @Test
    void itIsFoundBySuffix() {
        assertThat(ServiceLoader.load(SceneFormat.class).stream().map(ServiceLoader.Provider::get))
                .extracting(SceneFormat::suffix)
                .contains(".world.yaml");
    }

    @Test
    void anEmptyWorldIsOne() {
        Scene scene = scene("");
        assertThat(scene.things()).isEmpty();
        assertThat(scene.step()).isEmpty();
        assertThat(scene.map().cells()).containsOnly(OccupancyGrid.FREE);
    }

    @Test
    void robotsStallUnlessTheWorldSaysOtherwise() {
        assertThat(scene("").touch()).isEqualTo(Touch.STALL);
        assertThat(scene("onCollision: slide").touch()).isEqualTo(Touch.SLIDE);
        assertThat(SceneWriter.write(scene("onCollision: slide"), "a").yaml()).contains("onCollision: slide");
        assertThat(Worlds.of("onCollision: slid").errors())
                .singleElement()
                .asString()
                .contains("Maybe 'slide'");
    }

    @Test
    void anAreaIsOnTheMap() {
        OccupancyGrid map = scene("area: [-10, -3, 20, 4]").map();
        assertThat(map.originX()).isLessThanOrEqualTo(-10);
        assertThat(map.originX() + map.width() * map.resolution()).isBetween(20.0, 21.0);
        assertThat(map.isFree(19, 3)).isTrue();
    }

    @Test
    void aLineIsAWallOfItsThickness() {
        Scene scene = scene("walls: [{line: [[0, 0], [4, 0], [4, 3]], thickness: 0.2, height: 1, color: '#112233'}]");
        Entity wall = Worlds.thing(scene, "wall-1");
        assertThat(wall.blocks()).hasSize(2).allSatisfy(block -> {
            assertThat(block.prism().top()).isEqualTo(1);
            assertThat(block.surface().color()).isEqualTo(new Rgb(0x11, 0x22, 0x33));
        });
        assertThat(holds(wall, 4.099, -0.099)).as("the outer corner").isTrue();
        assertThat(holds(wall, 3.89, 0.11)).as("the inner corner").isFalse();
        assertThat(holds(wall, 2, 0.099) && holds(wall, 2, -0.099)).isTrue();
        assertThat(holds(wall, 2, 0.101) || holds(wall, -0.001, 0) || holds(wall, 4, 3.001))
                .isFalse();
        assertThat(occupied(scene, 2, 0) && occupied(scene, 4, 2)).isTrue();
        assertThat(occupied(scene, 2, 1)).isFalse();
    }

    /// A line's wall is what is no farther than half its thickness, but for corners and ends.
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void linesHaveNoGaps(boolean closed) {
        var random = new java.util.Random(7);
        for (int run = 0; run < 200; run++) {
            var points = new ArrayList<Point2d>();
            for (int i = 0; i < 3 + random.nextInt(5); i++) {
                points.add(new Point2d(random.nextDouble(-5, 5), random.nextDouble(-5, 5)));
            }
            double half = random.nextDouble(0.05, 1);
            var wall = new Entity(
                    "wall",
                    Line.shapes(points, closed, 2 * half).stream()
                            .map(shape -> new Block(rsal.data.Prism.standing(shape, 1), rsal.scene.Surface.PLAIN))
                            .toList(),
                    Pose2d.ORIGIN,
                    0);
            for (int k = 0; k < 200; k++) {
                int i = random.nextInt(points.size() - (closed ? 0 : 1));
                Point2d a = points.get(i);
                Point2d b = points.get((i + 1) % points.size());
                double along = random.nextDouble(0.001, 0.999);
                double aside = random.nextDouble(-0.999, 0.999) * half;
                double dx = (b.x() - a.x()) / a.distanceTo(b);
                double dy = (b.y() - a.y()) / a.distanceTo(b);
                double x = a.x() + along * (b.x() - a.x()) - aside * dy;
                double y = a.y() + along * (b.y() - a.y()) + aside * dx;
                assertThat(holds(wall, x, y))
                        .as("run %d: %s, %s of %s by %s", run, x, y, points, half)
                        .isTrue();
            }
        }
    }

    @Test
    void aThinLineIsAMillimeterThick() {
        Entity wall = Worlds.thing(scene("walls: [{line: [[0, 0], [0, 2]], thickness: 0}]"), "wall-1");
        assertThat(((Shape.Polygon) wall.blocks().getFirst().prism().shape()).area())
                .isCloseTo(0.002, within(1e-12));
    }

    @Test
    void aClosedLineGoesBackToWhereItBegan() {
        for (String points : List.of("[[0, 0], [4, 0], [4, 3], [0, 3]]", "[[0, 0], [4, 0], [4, 3], [0, 3], [0, 0]]")) {
            Entity wall = Worlds.thing(scene("walls: [{line: %s, closed: true}]".formatted(points)), "wall-1");
            assertThat(wall.blocks()).hasSize(4);
            assertThat(holds(wall, 0, 1.5) && holds(wall, -0.049, -0.04)).isTrue();
        }
    }

    @Test
    void shapesAreSolidOrHollow() {
        Scene scene = scene("""
                walls:
                  - {radius: 1, center: [3, 0]}
                  - {radius: 1, center: [-3, 0], thickness: 0.1}
                  - {length: 2, width: 1, pose: [0, 5, 90], bottom: 0.5, height: 0.25}
                  - {outline: [[0, -5], [2, -5], [0, -3]]}
                """);
        assertThat(holds(Worlds.thing(scene, "wall-1"), 3, 0)).isTrue();
        assertThat(holds(Worlds.thing(scene, "wall-2"), -3, 0)).isFalse();
        assertThat(holds(Worlds.thing(scene, "wall-2"), -3 + 0.72, 0.69)).isTrue();
        Entity box = Worlds.thing(scene, "wall-3");
        assertThat(holds(box, 0.4, 5.9)).isTrue();
        assertThat(holds(box, 0.9, 5.4)).isFalse();
        assertThat(box.blocks().getFirst().prism().bottom()).isEqualTo(0.5);
        assertThat(box.blocks().getFirst().prism().top()).isEqualTo(0.75);
        assertThat(holds(Worlds.thing(scene, "wall-4"), 0.5, -4.5)).isTrue();
        assertThat(occupied(scene, 3.9, 0) && occupied(scene, 3, 0))
                .as("a disc on the map")
                .isTrue();
        assertThat(occupied(scene, 3.8, 0.8) || occupied(scene, -3, 0)).isFalse();
    }

    private static final String PLAN = """
            ##+
            #..""";

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            resolution: 0.5, origin: [1, 2, 0]   | 1    | 2   | 3 | 2 | 0.5 | 0.5
            resolution: [0.5, 1]                 | 0    | 0   | 3 | 2 | 0.5 | 1
            size: [6, 5], origin: [0, 0, 90]     | -5   | 0   | 2 | 3 | 2.5 | 2
            size: [6, 5], origin: [0, 0, 180]    | -6   | -5  | 3 | 2 | 2   | 2.5
            """)
    void imagesAreCells(String how, double left, double bottom, int width, int height, double x, double y) {
        Scene scene = Worlds.of("walls: [{image: a.pgm, %s}]".formatted(how))
                .andImage("a.pgm", PLAN)
                .read();
        SolidRaster raster = scene.walls().getFirst();
        assertThat(raster.left()).isCloseTo(left, within(1e-12));
        assertThat(raster.bottom()).isCloseTo(bottom, within(1e-12));
        assertThat(List.of(raster.width(), raster.height())).containsExactly(width, height);
        assertThat(List.of(raster.cellX(), raster.cellY())).containsExactly(x, y);
        assertThat(raster.solid().cardinality()).isEqualTo(4); // + is dark, too
        assertThat(raster.lowest()).isInfinite();
        assertThat(raster.fenced()).isFalse();
    }

    @Test
    void anImageSaysWhatIsSolidOfIt() {
        Scene scene = Worlds.of(
                        "walls: [{image: a.pgm, resolution: 1, threshold: 0.3, bottom: 0.1, height: 0.5, fenced: true, blob: false}]")
                .andImage("a.pgm", PLAN)
                .read();
        SolidRaster raster = scene.walls().getFirst();
        assertThat(raster.solid().cardinality()).isEqualTo(3);
        assertThat(raster.lowest()).isEqualTo(0.1);
        assertThat(raster.highest()).isEqualTo(0.6);
        assertThat(raster.fenced()).isTrue();
        assertThat(raster.surface().blob()).isFalse();
    }

    @Test
    void aTurnedImageBecomesRectangles() {
        Scene scene = Worlds.of("walls: [{image: a.pgm, resolution: 1, origin: [0, 0, 45]}]")
                .andImage("a.pgm", PLAN)
                .read();
        assertThat(scene.walls()).isEmpty();
        Entity wall = Worlds.thing(scene, "wall-1");
        assertThat(holds(wall, 0, 0.7)).isTrue();
        assertThat(holds(wall, 1.4, 1.5)).isFalse();
        assertThat(holds(wall, 0.7, 3)).isTrue();
    }

    @Test
    void filesAreBesideTheWorld() {
        var worlds = Worlds.of("")
                .and("maps/a.world.yaml", "rsal: 1\nwalls: [{image: a.pgm, resolution: 1}, {map: m.yaml}]");
        worlds.andImage("maps/a.pgm", PLAN).and("maps/m.yaml", "image: a.pgm\nresolution: 0.5\norigin: [7, 8, 0]\n");
        Scene scene = new YamlFormat().read("maps/a.world.yaml", worlds.source(), 1);
        assertThat(scene.walls()).hasSize(2);
        assertThat(scene.walls().getLast().left()).isEqualTo(7);
        assertThat(scene.walls().getLast().fenced()).isTrue();
    }

    @Test
    void thingsSayWhatOthersMakeOfThem() {
        Scene scene = scene("""
                things:
                  box:
                    pose: [1, 2, 90, 0.5]
                    body: {pieces: [{length: 2, width: 1}, {radius: 0.1, bottom: 0.25, color: '#00ff00', fiducial: 3}]}
                    color: '#0000ff'
                    obstacle: false
                    reflectance: 0.5
                    blob: false
                    fiducial: 7
                    key: 2
                    grippable: true
                """);
        Entity box = Worlds.thing(scene, "box");
        assertThat(box.mapFromEntity().isNear(Pose2d.ofDegrees(1, 2, 90), 0, 0)).isTrue();
        assertThat(box.height()).isEqualTo(0.5);
        assertThat(box.blocks().getFirst().surface())
                .isEqualTo(new rsal.scene.Surface(new Rgb(0, 0, 255), false, 0.5, false, 7, 2, true));
        assertThat(box.blocks().getLast().surface())
                .isEqualTo(new rsal.scene.Surface(new Rgb(0, 255, 0), false, 0.5, false, 3, 2, true));
    }

    @Test
    void thingsMayBeSeveral() {
        Scene scene = scene("""
                things:
                  row: {count: 3, pose: {first: [1, 2, 90], step: [0.5, -1]}, body: {radius: 0.1}}
                  list: {pose: [[0, 0, 0], [1, 0, 0]], body: {radius: 0.1}}
                  fewer: {count: 1, pose: [[0, 5, 0], [1, 5, 0]], body: {radius: 0.1}}
                """);
        assertThat(scene.things())
                .extracting(Entity::name)
                .containsExactly("row-1", "row-2", "row-3", "list-1", "list-2", "fewer-1");
        assertThat(scene.things().get(2).mapFromEntity().isNear(Pose2d.ofDegrees(2, 0, 90), 1e-12, 1e-12))
                .isTrue();
    }

    @Test
    void whatMovesIsNotOnTheMap() {
        Scene scene = scene("""
                things:
                  fixed: {pose: [0, 0, 0], body: {radius: 0.3}}
                  cup: {pose: [2, 0, 0], body: {radius: 0.3}, grippable: true}
                  chair: {pose: [4, 0, 0], body: {radius: 0.3}, moves: true}
                """);
        assertThat(occupied(scene, 0, 0)).isTrue();
        assertThat(occupied(scene, 2, 0) || occupied(scene, 4, 0)).isFalse();
        assertThat(scene.map().contains(scene.map().column(4.3), 0)).isTrue();
    }

    @Test
    void robotsAreOfAnyModel() {
        Scene scene = Worlds.of("""
                models:
                  cart:
                    body: {pieces: [{length: 0.4, width: 0.3}, {radius: 0.05, bottom: 0.3, color: '#00ff00', obstacle: false}]}
                    drive: {maxSpeed: 1, maxTurnRate: 90, maxAcceleration: 1, maxTurnAcceleration: 90,
                            odometryNoise: {distancePerMeter: 0, headingPerMeter: 0, headingPerDegree: 0}}
                    mounts: {laser: [0.1, 0, 0, 0.2]}
                    sensors: {laser: eye}
                parts:
                  eye: {type: laser, fieldOfView: 90, samples: 10, range: [0, 5], noise: 0, period: 0.1}
                robots:
                  r0: {model: cart, pose: [0, 0, 0], program: wander, odometry: start}
                  r1: {model: pioneer2dx, role: guard, pose: [2, 0, 0], devices: {laser: eye, sonar: none}, color: '#ff0000'}
                  r2: {model: my.yaml, count: 2, pose: [[4, 0, 0], [5, 0, 90]], fiducial: 4, odometry: [1, 2, 30]}
                """).and("my.yaml", """
                title: Mine
                body: {radius: 0.2}
                drive: {maxSpeed: 1, maxTurnRate: 90, maxAcceleration: 1, maxTurnAcceleration: 90,
                        odometryNoise: {distancePerMeter: 0, headingPerMeter: 0, headingPerDegree: 0}}
                """).read();
        assertThat(scene.robots()).extracting(RobotSpec::id).containsExactly("r0", "r1", "r2-1", "r2-2");
        assertThat(scene.robots()).extracting(RobotSpec::role).containsExactly("r0", "guard", "r2", "r2");
        assertThat(scene.robots())
                .extracting(r -> r.model().title())
                .containsExactly("cart", "Pioneer 2-DX", "Mine", "Mine");
        assertThat(scene.robots().getFirst().model().body().pieces()).hasSize(1); // the other is in nobody's way
        assertThat(scene.robots().getFirst().model().heights()).containsEntry("laser", 0.2);
        assertThat(scene.robots().get(1).model().sensors()).containsOnlyKeys("laser");
        assertThat(scene.robotBodies()).containsOnlyKeys("r0", "r2-1", "r2-2");
        assertThat(java.util.Objects.requireNonNull(scene.robotBodies().get("r0"))
                        .blocks())
                .extracting(block -> block.surface().color().toString())
                .containsExactly(scene.robots().getFirst().color(), "#00ff00");
        assertThat(java.util.Objects.requireNonNull(scene.robotBodies().get("r2-1"))
                        .blocks())
                .allSatisfy(block -> assertThat(block.surface().fiducial()).isEqualTo(4));
        assertThat(scene.odomFromBase()).containsOnlyKeys("r0", "r2-1", "r2-2");
        assertThat(scene.odomFromBase()).containsEntry("r2-1", Pose2d.ofDegrees(1, 2, 30));
        assertThat(scene.programs()).containsOnlyKeys("r0");
    }

    @Test
    void robotsFindPlacesByThemselves() {
        Worlds worlds = Worlds.of("""
                walls: [{line: [[0, 0], [6, 0], [6, 6], [0, 6]], closed: true}]
                things: {cup: {pose: [2, 2, 0], body: {radius: 1}, grippable: true}}
                robots:
                  r: {model: pioneer2dx, count: 6, pose: {free: true, clearance: 0.5, within: [0, 0, 6, 4]}}
                  s: {model: pioneer2dx}
                """);
        Scene scene = worlds.read(3);
        List<Pose2d> poses =
                scene.robots().stream().map(r -> r.mapFromBase().orElseThrow()).toList();
        assertThat(poses.subList(0, 6)).allSatisfy(pose -> {
            assertThat(pose.x()).isBetween(0.5, 5.5);
            assertThat(pose.y()).isBetween(0.5, 4.0);
            assertThat(pose.distanceTo(new Pose2d(2, 2, 0))).isGreaterThan(1.4);
        });
        for (int i = 0; i < poses.size(); i++) {
            for (int j = 0; j < i; j++) {
                assertThat(poses.get(i).distanceTo(poses.get(j))).isGreaterThan(0.5);
            }
        }
        assertThat(Worlds.parts(worlds.read(3))).isEqualTo(Worlds.parts(scene));
        assertThat(worlds.read(4).robots()).isNotEqualTo(scene.robots());
    }

    private static final String FIELD = """
            walls: [{line: [[0, 0], [20, 0], [20, 20], [0, 20]], closed: true}]
            things: {tree: {pose: [10, 10, 0], body: {radius: 2}}, cup: {pose: [3, 3, 0], body: {radius: 1}, grippable: true}}
            robots: {r: {model: pioneer2dx, pose: [15, 15, 0]}}
            fields: {rocks: {count: 60, size: [0.2, 1], height: [0.3, 0.6], gap: 0.6, robotGap: 2, colors: ['#111111', '#222222']}}
            """;

    @Test
    void fieldsKeepTheirDistances() {
        Scene scene = scene(FIELD);
        assertThat(scene.warnings()).isEmpty();
        List<Entity> rocks = scene.things().stream()
                .filter(thing -> thing.name().startsWith("rocks-"))
                .toList();
        assertThat(rocks).hasSize(60);
        assertThat(scene.contents()).containsEntry("rocks", 60);
        for (Entity rock : rocks) {
            Point2d at = rock.mapFromEntity().position();
            double radius = Room.radius(rock);
            Block block = rock.blocks().getFirst();
            assertThat(block.prism().top()).isBetween(0.3, 0.6);
            assertThat(block.surface().color().toString()).isIn("#111111", "#222222");
            assertThat(radius).isBetween(0.1, Math.hypot(0.5, 0.5));
            assertThat(Math.min(Math.min(at.x(), at.y()), Math.min(20 - at.x(), 20 - at.y())) - radius)
                    .isGreaterThan(0.6);
            assertThat(at.distanceTo(new Point2d(10, 10)) - radius).isGreaterThan(2.6);
            assertThat(at.distanceTo(new Point2d(3, 3)) - radius).isGreaterThan(1.6 - 1e-9);
            assertThat(at.distanceTo(new Point2d(15, 15)) - radius).isGreaterThan(2.1);
            assertThat(rocks)
                    .filteredOn(other -> !other.equals(rock))
                    .allSatisfy(other -> assertThat(
                                    at.distanceTo(other.mapFromEntity().position()) - radius - Room.radius(other))
                            .isGreaterThan(0.6 - 1e-9));
            assertThat(occupied(scene, at.x(), at.y())).isTrue();
        }
        assertThat(rocks.stream()
                        .map(rock -> rock.blocks().getFirst().prism().shape().getClass())
                        .distinct())
                .hasSize(2);
    }

    @Test
    void equalSeedsGrowEqualFields() {
        Worlds worlds = Worlds.of(FIELD);
        assertThat(worlds.read(5).things()).isEqualTo(worlds.read(5).things());
        assertThat(worlds.read(6).things()).isNotEqualTo(worlds.read(5).things());
        Worlds own = Worlds.of(FIELD.replace("gap: 0.6", "gap: 0.6, seed: 9"));
        assertThat(own.read(6).things()).isEqualTo(own.read(5).things());
    }

    @Test
    void aFieldMayBeAsDenseAsOneLikes() {
        Scene scene = scene(
                "area: [0, 0, 10, 4]\nfields: {f: {density: 0.5, area: [1, 1, 9, 3], shapes: [disc], size: 0.1, gap: 0.1}}");
        assertThat(scene.things())
                .hasSize(8)
                .allSatisfy(
                        thing -> assertThat(thing.blocks().getFirst().prism().shape())
                                .isEqualTo(new Shape.Disc(new Point2d(0, 0), 0.05)));
    }

    @Test
    void aFieldWithoutRoomIsSmaller() {
        Scene scene = scene("area: [0, 0, 3, 3]\nfields: {rocks: {count: 500, size: 0.5, area: [0, 0, 3, 3]}}");
        assertThat(scene.things()).hasSizeBetween(2, 30);
        assertThat(scene.warnings()).singleElement().satisfies(warning -> {
            assertThat(warning.location()).isEqualTo(new Location(Worlds.FILE, 3, 17));
            assertThat(warning.message()).matches("Only \\d+ of 500 obstacles 'rocks' found room\\.");
        });
    }

    @Test
    @Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
    void aThingAsLargeAsTheWorldTakesNoLongerThanASmallOne() {
        Scene scene = scene("""
                things: {fog: {pose: [0, 0, 0], moves: true, body: {outline: [[0, 0], [60000, 0], [60000, 60000]]}}}
                fields: {rocks: {count: 5, area: [0, 0, 9, 9]}}
                """);
        assertThat(scene.warnings()).singleElement().asString().contains("Only 0 of 5 obstacles 'rocks'");
    }

    @Test
    void robotsMayAskForManyClearances() {
        var robots = new StringBuilder("area: [0, 0, 40, 40]\nrobots:\n");
        for (int i = 0; i < 300; i++) {
            robots.append("  r%d: {model: pioneer2dx, pose: {free: true, clearance: %s}}\n"
                    .formatted(i, 0.45 + 0.01 * (i % 7) + 1e-6 * i));
        }
        assertThat(scene(robots.toString()).robots()).hasSize(300);
    }

    @Test
    void anImageOfTooManyPiecesCanNotBeTurned() {
        String rows = ("#.".repeat(200) + "\n" + ".#".repeat(200) + "\n").repeat(200);
        Worlds worlds = Worlds.of("walls: [{image: board.pgm, resolution: 0.1, origin: [0, 0, 30]}]");
        assertThat(worlds.andImage("board.pgm", rows).errors())
                .singleElement()
                .asString()
                .contains("The image has more than 50000 pieces");
    }

    @Test
    void aFieldThatIsTooDenseSaysSo() {
        Scene scene =
                scene("fields: {f: {density: 1000, area: [0, 0, 100, 50], size: 0.01, gap: 0}}\narea: [0, 0, 1, 1]");
        assertThat(scene.warnings())
                .extracting(Problem::message)
                .contains("Only 10000 of 5000000 obstacles 'f' are made.");
    }

    @Test
    void aWorldHasOnlySoManyImages() {
        String image = "{image: a.pgm, resolution: 1},";
        assertThat(Worlds.of("walls: [" + image.repeat(1000) + "]")
                        .andImage("a.pgm", PLAN)
                        .errors())
                .isEmpty();
        assertThat(Worlds.of("walls: [" + image.repeat(1001) + "]")
                        .andImage("a.pgm", PLAN)
                        .errors())
                .singleElement()
                .asString()
                .contains("more than 1000 images and maps");
    }

    @Test
    void colorsMayHaveNames() {
        String text = """
                walls: [{radius: 1, center: [5, 5], color: COLOR}]
                things: {a: {body: {radius: 1}, color: COLOR}}
                fields: {f: {area: [-9, -9, 0, 0], count: 1, seed: 1, colors: [COLOR]}}
                parts: {eye: {type: blob-finder, image: [80, 60], fieldOfView: 60, range: 4, colors: [COLOR], period: 0.1}}
                robots: {r: {model: pioneer2dx, pose: [3, 3, 0], color: COLOR, devices: {camera: eye}}}
                """;
        assertThat(Worlds.parts(Worlds.of(text.replace("COLOR", "Steel Blue")).read()))
                .isEqualTo(Worlds.parts(
                        Worlds.of(text.replace("COLOR", "\"#4682b4\"")).read()));
    }

    @Test
    void aBumperThatFeelsNothingIsReported() {
        Scene scene = Worlds.of("""
                        parts: {numb: {type: bumper, bumpers: [], period: 0.1}}
                        robots:
                          r: {model: pioneer2dx, pose: [[0, 0, 0], [2, 2, 0]], devices: {bumper: numb}}
                        """).read();
        assertThat(scene.robots()).hasSize(2);
        assertThat(scene.warnings())
                .singleElement()
                .asString()
                .startsWith("hall.world.yaml:4:6: Bumper 'bumper' of the model 'pioneer2dx' feels nothing");
    }

    @Test
    void robotsThatStartInsideSomethingAreReported() {
        Scene scene = scene("""
                walls: [{line: [[-5, 0], [5, 0]], thickness: 0.1}]
                things: {box: {pose: [2, 2, 0], body: {length: 1, width: 1, height: 1}}}
                robots:
                  r: {model: pioneer2dx, pose: [[0, 0.1, 0], [2.2, 2, 0], [-2, 2, 0]]}
                  late: {model: pioneer2dx, pose: [-2, 2.1, 0]}
                """);
        assertThat(scene.warnings())
                .extracting(Problem::toString)
                .satisfiesExactly(
                        wall -> assertThat(wall).startsWith("hall.world.yaml:5:6: Robot 'r-1' starts inside 'wall-1'."),
                        box -> assertThat(box).contains("Robot 'r-2' starts inside 'box'."),
                        robot -> assertThat(robot).contains("Robot 'late' starts inside 'r-3'."));
    }

    @Test
    void errorsDoNotHideWarnings() {
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> scene("""
                        robots: {r: {model: pioneer2dx, pose: [0, 0, 0], program: dance}}
                        wals: []
                        """))
                .satisfies(e -> {
                    assertThat(e.problems()).singleElement().asString().contains("wals");
                    assertThat(e.warnings()).singleElement().asString().contains("'dance'");
                });
    }

    @Test
    void otherProgramsAreReported() {
        Scene scene = scene("robots: {r: {model: pioneer2dx, pose: [0, 0, 0], program: dance}}");
        assertThat(scene.programs()).containsEntry("r", "dance");
        assertThat(scene.warnings()).singleElement().asString().contains("'dance'", "wander");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
            rsal: 2                                        | 2:7   | This world has format '2'; this RSAL reads format 1.
            wals: []                                       | 2:1   | Maybe 'walls' was meant?
            step: 1                                        | 2:7   | 'step' must be a number from 0.01 to 0.2 [s], not '1'
            area: [0, 0, 0, 5]                             | 2:7   | 'area' must be [left, bottom, right, top]
            walls: 3                                       | 2:8   | 'walls' must be a list
            walls: [3]                                     | 2:9   | a list of groups such as {line
            walls: [{lien: [[0, 0]]}]                      | 2:9   | Maybe 'line' was meant?
            walls: [{line: [[0, 0]]}]                      | 2:16  | two points or more
            walls: [{line: [[0, 0], [0, 0], [1, 1]]}]      | 2:16  | is followed by itself
            walls: [{line: [[0, 0], [0, a]]}]              | 2:25  | a list of 2 numbers
            walls: [{line: [[0, 0], [0, 1e9]]}]            | 2:16  | must be at most 1000000.0 away
            walls: [{radius: -1}]                          | 2:18  | 'walls.radius' must be a number from 0.0000010
            walls: [{radius: 1, heigth: 3}]                | 2:21  | Maybe 'height' was meant?
            walls: [{radius: 1, height: -3}]               | 2:29  | 'walls.height' must be a number from 0
            walls: [{image: none.png, resolution: 1}]      | 2:17  | There is no file 'none.png'
            walls: [{image: a.pgm}]                        | 2:9   | a 'resolution', or a 'size', not none
            walls: [{image: a.pgm, resolution: 0}]         | 2:36  | Pixels of 0.0
            walls: [{image: what.png, resolution: 1}]      | 2:17  | Image 'what.png' can't be read: it is not an image
            walls: [{map: offcie}]                         | 2:15  | There is no map 'offcie'
            things: {wall: {body: {radius: 1}}}            | 2:16  | 'wall' can't be a name here
            things: {wall-1: {body: {radius: 1}}}          | 2:18  | two of the name 'wall-1'
            things: {a: {body: {radius: 1}, givingPower: -5}} | 2:46 | 'things.a.givingPower' must be a number
            things: {a: {}}                                | 2:13  | 'things.a.body' is missing
            things: {a: {body: {radius: 1}, colour: red}}  | 2:33  | Maybe 'color' was meant?
            things: {a: {body: {radius: 1}, color: rde}}   | 2:40  | must be a color, "#rrggbb" or a name, not 'rde'.
            things: {a: {body: {radius: 1}, color: rde}}   | 2:40  | Maybe 'red' was meant?
            things: {a: {body: {radius: 1}, color: "#12"}} | 2:40  | such as red, orange or gray30
            things: {a: {body: {radius: 1}, color: [1]}}   | 2:40  | or a name, not a list of 1
            fields: {a: {count: 1, colors: [red, rde]}}    | 2:38  | Maybe 'red' was meant?
            things: {a: {body: {radius: 1}, blob: 1}}      | 2:39  | 'things.a.blob' must be true or false, not '1'
            things: {a: {pose: [1, 2], body: {radius: 1}}} | 2:20  | 'things.a.pose' must be a list of 3 numbers
            things: {a: {count: 2, pose: [1, 2, 3], body: {radius: 1}}} | 2:30 | 'things.a.pose' has 1 for 2
            things: {a: {body: {pieces: []}}}              | 2:20  | 'things.a.body' must have pieces
            fields: {f: {}}                                | 2:13  | must have a 'count', or a 'density'
            fields: {f: {count: 1, size: [2, 1]}}          | 2:30  | 'fields.f.size' must be [least, most]
            fields: {f: {count: 1, shapes: [ball]}}        | 2:33  | Known are: disc, box, polygon
            robots: {r: {}}                                | 2:13  | 'robots.r.model' is missing
            robots: {r: {model: pioner2dx}}                | 2:21  | Maybe 'pioneer2dx' was meant?
            robots: {r: {model: pioneer2dx, devices: {laser: urg4lx}}} | 2:50 | Maybe 'urg04lx' was meant?
            robots: {a/b: {model: pioneer2dx}}             | 2:15  | a slash separates robots from devices
            robots: {r: {model: pioneer2dx, pose: {free: 3}}} | 2:46 | can only be true
            robots: {r: {model: pioneer2dx, pose: {free: true, within: [50, 50, 51, 51]}}} | 2:13 | no free place for robot 'r'
            robots: {r: {model: pioneer2dx, pose: {free: true, within: [5, 0, 1, 1]}}} | 2:60 | 'robots.r.pose.within' must be [left, bottom
            robots: {r: {model: pioneer2dx, pose: {free: true, within: [0, 0, 1e7, 1]}}} | 2:60 | 'robots.r.pose.within' must be within
            models: {m: {body: {radius: 1}}}               | 2:13  | 'models.m.drive' is missing: a group with 'maxSpeed'
            models: {m: {body: {radius: 1, actuator: arn}, mounts: {arm: [0, 0, 0]}}} | 2:42 | Maybe 'arm' was meant?
            things: {a: {body: {radius: 1, actuator: arm}}} | 2:32 | 'actuator' is not known
            things: {a: {pose: [900000, 0, 0], body: {radius: 1}}, b: {body: {radius: 1}}} | | at most 100000 m
            """)
    void errorsAreReported(String text, String where, String expected) {
        Worlds worlds = Worlds.of(text.startsWith("rsal") ? "" : text + "\nwalls: [{line: [[-1, -9], [-1, 9]]}]")
                .andImage("a.pgm", PLAN)
                .and("what.png", "what");
        if (text.startsWith("rsal")) {
            worlds.and(Worlds.FILE, "\n" + text);
        } else if (text.startsWith("walls")) {
            worlds.and(Worlds.FILE, "rsal: 1\n" + text);
        }
        assertThat(worlds.errors())
                .anySatisfy(error -> assertThat(error)
                        .startsWith(Worlds.FILE + (where == null ? ":" : ":" + where + ":"))
                        .contains(expected));
    }

    @Test
    void piecesOfABodyMoveWithTheActuatorThatTheyName() {
        String world = """
                models:
                  cart:
                    body:
                      pieces: [{length: 0.4, width: 0.3}, {length: 0.5, width: 0.05, center: [0.3, 0], bottom: 0.2, actuator: arm}]
                    drive: {maxSpeed: 1, maxTurnRate: 90, maxAcceleration: 1, maxTurnAcceleration: 90,
                            odometryNoise: {distancePerMeter: 0, headingPerMeter: 0, headingPerDegree: 0}}
                    mounts: {arm: [0, 0, 0], eye: {actuator: arm, pose: [0.5, 0, 0]}}
                    sensors: {arm: PART, eye: urg04lx}
                robots:
                  r: {model: cart, pose: [0, 0, 0], obstacle: false}
                """;
        Scene scene = Worlds.of(world.replace("PART", "turntable")).read();
        assertThat(java.util.Objects.requireNonNull(scene.robotBodies().get("r"))
                        .blocks())
                .extracting(block -> block.carrier().orElse("base"))
                .containsExactly("base", "arm");
        assertThat(scene.robots().getFirst().model().carriers()).isEqualTo(java.util.Map.of("eye", "arm"));
        assertThat(Worlds.of(world.replace("PART", "urg04lx")
                                .replace("{actuator: arm, pose: [0.5, 0, 0]}", "[0, 0, 0]"))
                        .errors())
                .singleElement()
                .asString()
                .contains("A piece of its body stands on 'arm', which is not an actuator.");
    }

    @ParameterizedTest
    @CsvSource(
            quoteCharacter = '`',
            delimiter = '|',
            value = {
                "odometryNoise: 5            | 'models.cart.drive.odometryNoise' must be a group of settings, not '5'.",
                "odometryNoise: [0, 0, 0]    | must be a group of settings, not a list of 3.",
                "odometryNoice: {distancePerMeter: 0, headingPerMeter: 0, headingPerDegree: 0} "
                        + "| Maybe 'odometryNoise' was meant?",
                "odometryNoise: {distancePerMetre: 0, headingPerMeter: 0, headingPerDegree: 0} "
                        + "| Maybe 'distancePerMeter' was meant?",
                "odometryNoise: {distancePerMeter: -1, headingPerMeter: 0, headingPerDegree: 0} | from 0.0 to 1000000000",
                "odometryNoise: {distancePerMeter: 0, headingPerMeter: 0} | headingPerDegree' is missing",
                "type: differential          | drive.odometryNoise' is missing: a group with 'distancePerMeter', 'headingPerMeter', "
                        + "'headingPerDegree'."
            })
    void anErrorInADriveIsReportedOnce(String noise, String expected) {
        assertThat(Worlds.of("""
                        robots: {r: {model: cart}, s: {model: cart, devices: {laser: urg04lx}}}
                        models:
                          cart:
                            body: {radius: 0.1}
                            drive: {maxSpeed: 1, maxTurnRate: 90, maxAcceleration: 1, maxTurnAcceleration: 90, NOISE}
                            mounts: {laser: [0, 0, 0]}
                        """.replace("NOISE", noise)).errors())
                .singleElement()
                .asString()
                .contains(expected);
    }

    @Test
    void allErrorsAreReportedTogether() {
        assertThat(Worlds.of("step: 7\nwalls: [{radius: 0}, {line: 3}]\nrobots: {r: {model: none}}")
                        .errors())
                .hasSizeBetween(4, 5);
        assertThat(Worlds.of("walls: [" + "{radius: 0},".repeat(300) + "]").errors())
                .hasSize(50);
    }
}
