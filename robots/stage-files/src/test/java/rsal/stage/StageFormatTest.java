package rsal.stage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotModel.RangeNoise;
import rsal.robot.RobotModel.Steering;
import rsal.robot.RobotSpec;
import rsal.scene.Entity;
import rsal.scene.Scene;
import rsal.scene.SolidRaster;
import rsal.settings.InvalidSettings;
import rsal.settings.Problem;

/// What becomes of worlds of Stage.
class StageFormatTest {
    private static Scene scene(String text) {
        return scene(Worlds.of(text), 1);
    }

    private static Scene scene(Worlds worlds, long seed) {
        return new StageFormat().read("test.world", worlds.source(), seed);
    }

    private static Entity thing(Scene scene, String name) {
        return scene.things().stream()
                .filter(thing -> thing.name().equals(name))
                .findFirst()
                .orElseThrow();
    }

    private static Part part(Scene scene, String device) {
        Part part = scene.robots().getFirst().model().sensors().get(device);
        assertThat(part).as(device).isNotNull();
        return part;
    }

    private static List<String> warnings(Scene scene) {
        return scene.warnings().stream().map(Problem::toString).toList();
    }

    @Test
    void robotsThatStartInsideSomethingAreReported() {
        Scene scene = scene(Worlds.of("""
                        define cart position ( size [0.4 0.4 0.3] )
                        model ( name "plan" bitmap "plan.pgm" size [10 10 1] pose [0 0 0 0] )
                        model ( name "box" pose [2 0 0 0] )
                        cart ( name "in-wall" pose [-4.9 0 0 0] )
                        cart ( name "in-box" pose [2.3 0 0 0] )
                        cart ( name "beside" pose [1.6 0 0 0] )
                        cart ( name "above" pose [2 0 1 0] )
                        cart ( name "first" pose [0 3 0 0] )
                        cart ( name "second" pose [0.1 3.1 0 0] )
                        """).andImage("plan.pgm", RING), 1);
        assertThat(warnings(scene))
                .satisfiesExactly(
                        wall -> assertThat(wall)
                                .startsWith("test.world:4:1: Robot 'in-wall' starts inside a wall.\n    Give"),
                        box -> assertThat(box).startsWith("test.world:5:1: Robot 'in-box' starts inside 'box'."),
                        robot -> assertThat(robot).startsWith("test.world:9:1: Robot 'second' starts inside 'first'."));
    }

    /// Too large to be told in rectangles.
    private static final String RING =
            "#".repeat(120) + "\n" + ("#" + ".".repeat(118) + "#\n").repeat(118) + "#".repeat(120);

    /// A picture of a raster, the uppermost row first.
    private static String drawn(SolidRaster raster) {
        return IntStream.range(0, raster.height())
                .map(row -> raster.height() - 1 - row)
                .mapToObj(row -> IntStream.range(0, raster.width())
                        .mapToObj(column -> raster.solid().get(row * raster.width() + column) ? "#" : ".")
                        .collect(Collectors.joining()))
                .collect(Collectors.joining("\n"));
    }

    private static boolean occupied(Scene scene, double x, double y) {
        OccupancyGrid map = scene.map();
        return map.at(map.column(x), map.row(y)) == OccupancyGrid.OCCUPIED;
    }

    @Test
    void theWorldItself() {
        Scene scene = scene("name \"hall\" interval_sim 50 quit_time 30");
        assertThat(scene.title()).isEqualTo("hall");
        assertThat(scene.step()).contains(Duration.ofMillis(50));
        assertThat(scene.end()).contains(Duration.ofSeconds(30));
        assertThat(scene.robots()).isEmpty();
        assertThat(scene.things()).isEmpty();
        assertThat(scene.map().cells()).containsOnly(OccupancyGrid.FREE);
    }

    @Test
    void stepsThatCanNotBeAreChangedWithAWarning() {
        Scene scene = scene("interval_sim 1");
        assertThat(scene.step()).contains(Duration.ofMillis(10));
        assertThat(warnings(scene)).singleElement().asString().contains("'interval_sim'", "10 ms");
    }

    @Test
    void modelsAreThings() {
        Scene scene = scene("""
                model ( name "box" pose [1 2 0.5 90] size [2 1 0.4] color "blue" obstacle_return 0 ranger_return 0.5
                        blob_return 0 fiducial_return 7 fiducial_key 3 gripper_return 1
                  model ( name "top" pose [0.5 0 0 0] size [0.2 0.2 0.1] ) )
                """);
        Entity box = thing(scene, "box");
        assertThat(box.mapFromEntity().isNear(Pose2d.ofDegrees(1, 2, 90), 1e-9, 1e-9))
                .isTrue();
        assertThat(box.height()).isEqualTo(0.5);
        var block = box.blocks().getFirst();
        assertThat(block.prism().top()).isEqualTo(0.4);
        assertThat(((Shape.Polygon) block.prism().shape()).area()).isCloseTo(2, within(1e-9));
        assertThat(block.surface().color()).isEqualTo(new Rgb(0, 0, 255));
        assertThat(block.surface().obstacle()).isFalse();
        assertThat(block.surface().reflectance()).isEqualTo(0.5);
        assertThat(block.surface().blob()).isFalse();
        assertThat(block.surface().fiducial()).isEqualTo(7);
        assertThat(block.surface().fiducialKey()).isEqualTo(3);
        assertThat(block.surface().grippable()).isTrue();
        Entity top = thing(scene, "box.top");
        assertThat(top.height()).isCloseTo(0.9, within(1e-9));
        assertThat(top.mapFromEntity().isNear(Pose2d.ofDegrees(1, 2.5, 90), 1e-9, 1e-9))
                .isTrue();
    }

    private static final String BITMAP = """
            ##...
            #....
            #...#""";

    /// Larger than what is told in rectangles, of the same look.
    private static Worlds plan(String pose) {
        String wide = BITMAP.lines()
                .map(line -> line.chars()
                        .mapToObj(c -> Character.toString(c).repeat(60))
                        .collect(Collectors.joining()))
                .flatMap(line -> IntStream.range(0, 60).mapToObj(_ -> line))
                .collect(Collectors.joining("\n"));
        return Worlds.of("model ( name \"plan\" size [5 3 0.8] bitmap \"plan.pgm\" pose %s )".formatted(pose))
                .andImage("plan.pgm", wide);
    }

    private static String small(SolidRaster raster) {
        List<String> rows = drawn(raster).lines().toList();
        var small = new StringBuilder();
        for (int row = 30; row < rows.size(); row += 60) {
            for (int column = 30; column < rows.get(row).length(); column += 60) {
                small.append(rows.get(row).charAt(column));
            }
            small.append('\n');
        }
        return small.toString().strip();
    }

    @Test
    void largeBitmapsAreWalls() {
        Scene scene = scene(plan("[10 20 0 0]"), 1);
        assertThat(scene.things()).isEmpty();
        SolidRaster walls = scene.walls().getFirst();
        assertThat(small(walls)).isEqualTo(BITMAP);
        assertThat(walls.left()).isCloseTo(7.5, within(1e-9));
        assertThat(walls.bottom()).isCloseTo(18.5, within(1e-9));
        assertThat(walls.cellX()).isCloseTo(1 / 60.0, within(1e-9));
        assertThat(walls.highest()).isEqualTo(0.8);
        assertThat(walls.fenced()).isFalse();
        assertThat(occupied(scene, 7.6, 21.4)).isTrue();
        assertThat(occupied(scene, 9.6, 21.4)).isFalse();
        assertThat(occupied(scene, 12.4, 18.6)).isTrue();
    }

    @ParameterizedTest
    @ValueSource(ints = {90, 180, 270, -90, 360})
    void turnedBitmapsHaveTheirWallsWhereTheyBelong(int degrees) {
        Scene scene = scene(plan("[10 20 0 %d]".formatted(degrees)), 1);
        assertThat(scene.walls()).hasSize(1);
        assertThat(scene.things()).isEmpty();
        var mapFromPlan = Pose2d.ofDegrees(10, 20, degrees);
        for (int row = 0; row < 3; row++) {
            for (int column = 0; column < 5; column++) {
                var at = mapFromPlan.compose(new Pose2d(column - 2, 1 - row, 0));
                assertThat(occupied(scene, at.x(), at.y()))
                        .as("row %d, column %d", row, column)
                        .isEqualTo(BITMAP.lines().toList().get(row).charAt(column) == '#');
            }
        }
    }

    @Test
    void obliqueBitmapsAreThings() {
        Scene scene = scene(plan("[0 0 0 30]"), 1);
        assertThat(scene.walls()).isEmpty();
        var mapFromPlan = Pose2d.ofDegrees(0, 0, 30);
        var solid = mapFromPlan.compose(new Pose2d(-2, 1, 0));
        var free = mapFromPlan.compose(new Pose2d(0, 0, 0));
        assertThat(occupied(scene, solid.x(), solid.y())).isTrue();
        assertThat(occupied(scene, free.x(), free.y())).isFalse();
    }

    @Test
    void outlinesThatAreNoneBecomeTheNearestThatAre() {
        Scene scene = scene("""
                model ( name "wall" size [2 0 1] block ( points 2 point[0] [0 0] point[1] [1 0] ) )
                model ( name "bow" size [1 1 1] block ( points 4 point[0] [0 0] point[1] [1 1] point[2] [1 0] point[3] [0 1] ) )
                """);
        var wall =
                (Shape.Polygon) thing(scene, "wall").blocks().getFirst().prism().shape();
        assertThat(wall.area()).isCloseTo(0.002, within(1e-6));
        var bow =
                (Shape.Polygon) thing(scene, "bow").blocks().getFirst().prism().shape();
        assertThat(bow.area()).isCloseTo(1, within(1e-9));
        assertThat(warnings(scene))
                .singleElement()
                .asString()
                .startsWith("test.world:2:")
                .contains("meets itself");
    }

    private static final String CART = """
            define eye sensor ( range [0.2 8] fov 180 samples 181 noise [0.0004 0 0] size [0.02 0.02 0.04] )
            define cart position ( size [0.4 0.3 0.2] color "red" update_interval 100
              velocity_bounds [-0.5 0.5 0 0 0 0 -90 90] acceleration_bounds [-1 1 0 0 0 0 -180 180]
              ranger ( pose [0.1 0 0.05 0] size [0.1 0.1 0.1] block ( points 4 point[0] [0 0] point[1] [1 0] point[2] [1 1] point[3] [0 1] )
                eye ( pose [0 0 0.06 0] ) ) )
            """;

    @Test
    void basesAreRobotsWithAllThatStandsOnThem() {
        Scene scene = scene(CART + "cart ( name \"r0\" pose [1 2 0 90] ctrl \"wander 3\" )");
        RobotSpec robot = scene.robots().getFirst();
        assertThat(scene.robots()).hasSize(1);
        assertThat(robot.id()).isEqualTo("r0");
        assertThat(robot.role()).isEqualTo("cart");
        assertThat(robot.color()).isEqualTo("#ff0000");
        assertThat(robot.mapFromBase().orElseThrow().isNear(Pose2d.ofDegrees(1, 2, 90), 1e-9, 1e-9))
                .isTrue();
        assertThat(robot.model().name()).isEqualTo("cart");
        assertThat(scene.things()).isEmpty();
        Entity body = scene.robotBodies().get("r0");
        assertThat(body.blocks()).hasSize(2);
        assertThat(body.blocks().getLast().prism().bottom()).isCloseTo(0.25, within(1e-9));
        assertThat(body.blocks().getLast().prism().top()).isCloseTo(0.35, within(1e-9));
        assertThat(scene.programs()).containsEntry("r0", "wander");
        assertThat(scene.odomFromBase().get("r0").isNear(Pose2d.ofDegrees(1, 2, 90), 1e-9, 1e-9))
                .isTrue();
        assertThat(scene.contents()).containsEntry("cart", 1).containsEntry("ranger", 1);
        var drive = robot.model().drive();
        assertThat(drive.steering()).isEqualTo(new Steering.Differential());
        assertThat(drive.maxSpeed()).isEqualTo(0.5);
        assertThat(drive.maxTurnRate()).isCloseTo(Math.PI / 2, within(1e-9));
        assertThat(drive.maxAcceleration()).isEqualTo(1);
        assertThat(drive.maxTurnAcceleration()).isCloseTo(Math.PI, within(1e-9));
        assertThat(drive.odometryNoise().distancePerMeter()).isZero();
    }

    @Test
    void aRangerOfManyRaysIsALaser() {
        Scene scene = scene("interval_sim 40\n" + CART + "cart ( )");
        var laser = (Part.Laser) part(scene, "laser");
        assertThat(laser.samples()).isEqualTo(181);
        assertThat(laser.angleMin()).isCloseTo(-Math.PI / 2, within(1e-9));
        assertThat(laser.angleIncrement()).isCloseTo(Math.toRadians(1), within(1e-9));
        assertThat(laser.rangeMin()).isEqualTo(0.2);
        assertThat(laser.rangeMax()).isEqualTo(8);
        assertThat(laser.noise().deviation()).isCloseTo(0.02, within(1e-9));
        assertThat(laser.period()).isEqualTo(Duration.ofMillis(120));
        assertThat(laser.baseFromLaser().x()).isCloseTo(0.1, within(1e-9));
        assertThat(scene.robots().getFirst().model().height("laser")).isCloseTo(0.2 + 0.05 + 0.06 + 0.02, within(1e-9));
    }

    @Test
    void noiseIsWhatStageMakesOfIt() {
        Scene scene = scene("""
                position ( ranger ( sensor ( fov 180 samples 181 noise [0.0004 0.05 90] )
                                    sensor ( noise [0.01 0.1 90] ) sensor ( noise [0.01 0.2 90] ) ) )
                """);
        var laser = (Part.Laser) part(scene, "laser");
        assertThat(laser.noise().deviation()).isCloseTo(0.02, within(1e-9));
        assertThat(laser.noise().share()).isEqualTo(0.05);
        assertThat(laser.noise().angle())
                .as("half of 90° in rad, times 1°")
                .isCloseTo(Math.PI / 4 * Math.toRadians(1), within(1e-9));
        assertThat(((Part.Sonars) part(scene, "sonar")).noise()).isEqualTo(new RangeNoise(0.1, 0.1, 0));
        assertThat(((Part.Sonars) part(scene, "sonar-2")).noise()).isEqualTo(new RangeNoise(0.1, 0.2, 0));
        assertThat(warnings(scene)).isEmpty();
    }

    @Test
    void finderAndGripperAreAsTheyAreMeant() {
        Scene scene = scene("""
                position ( fiducial ( ignore_zloc 1 ) gripper ( paddle_state [ "closed" "up" ] autosnatch 1 ) )
                """);
        assertThat(((Part.FiducialFinder) part(scene, "fiducial-finder")).allHeights())
                .isTrue();
        var gripper = (Part.Gripper) part(scene, "gripper");
        assertThat(gripper.closed() && gripper.raised() && gripper.snatches()).isTrue();
        Scene plain = scene("position ( fiducial ( ) gripper ( ) )");
        assertThat(((Part.FiducialFinder) part(plain, "fiducial-finder")).allHeights())
                .isFalse();
        gripper = (Part.Gripper) part(plain, "gripper");
        assertThat(gripper.closed() || gripper.raised() || gripper.snatches()).isFalse();
    }

    @Test
    void thingsThatGiveAreChargers() {
        Scene scene = scene("""
                model ( name "station" pose [2 0 0 0] model ( name "plate" joules -1 give_watts 100 obstacle_return 0 ) )
                """);
        assertThat(thing(scene, "station").givingPower()).isZero();
        assertThat(thing(scene, "station.plate").givingPower()).isEqualTo(100);
        assertThat(warnings(scene)).isEmpty();
    }

    @Test
    void whatStandsOnARobotChargesIt() {
        Scene scene = scene("""
                define plug model ( size [0.1 0.1 0.1] take_watts 30 give_watts 4 )
                position ( joules 500 joules_capacity 1000 take_watts 3 plug ( model ( take_watts 2 ) )
                           model ( joules 7 take_watts 100 ) )
                """);
        var battery = (Part.Battery) part(scene, "battery");
        assertThat(battery.chargingPower()).isEqualTo(35);
        assertThat(battery.givingPower()).isEqualTo(4);
    }

    @Test
    void blocksMoveWithTheActuatorThatTheyAreIn() {
        Scene scene = scene("""
                position ( model ( ) actuator ( model ( ) actuator ( max_speed 0 model ( ) ) actuator ( model ( ) ) ) )
                """);
        assertThat(scene.robotBodies().values().iterator().next().blocks())
                .extracting(block -> block.carrier().orElse("base"))
                .containsExactly(
                        "base", "base", "actuator", "actuator", "actuator", "actuator", "actuator-3", "actuator-3");
    }

    @Test
    void whatIsInAnActuatorStandsOnItWhereThatStarts() {
        Scene scene = scene("""
                position ( size [1 1 0.2] ranger ( sensor ( samples 2 ) )
                  actuator ( size [0.1 0.1 0.1] pose [0.1 0 0 90] axis [1 0 2] start_position 0.5 max_speed 3
                    actuator ( noblocks 1 size [1 1 0.2] type "rotational" start_position 1 min_position -180 max_position 180
                      ranger ( pose [0.2 0 0 0] sensor ( samples 3 ) ) )
                    actuator ( noblocks 1 max_speed 0 blobfinder ( ) ) )
                  fiducial ( ) )
                """);
        RobotModel robot = scene.robots().getFirst().model();
        assertThat(robot.carriers())
                .isEqualTo(Map.of("actuator-2", "actuator", "laser-2", "actuator-2", "blob-finder", "actuator"));
        double along = 0.5 / Math.sqrt(5);
        Pose2d baseFromLaser = ((Part.Laser) part(scene, "laser-2")).baseFromLaser();
        assertThat(baseFromLaser.isNear(
                        new Pose2d(0.1, along, Math.PI / 2)
                                .compose(Pose2d.ofDegrees(0, 0, 1))
                                .compose(new Pose2d(0.2, 0, 0)),
                        1e-9,
                        1e-9))
                .as("%s", baseFromLaser)
                .isTrue();
        assertThat(robot.height("laser-2") - robot.height("laser")).isCloseTo(0.1 + 0.2 + 2 * along, within(1e-9));
        assertThat(((Part.Actuator) part(scene, "actuator")).slope()).isCloseTo(Math.atan(2), within(1e-12));
    }

    @Test
    void chargersThatCanNotBeAsTheyAreMeantAreReported() {
        Scene scene = scene("""
                model ( joules 100 give_watts 100 )
                model ( give_watts 100 noblocks 1 )
                """);
        assertThat(warnings(scene)).hasSize(2);
        assertThat(warnings(scene).getFirst())
                .asString()
                .startsWith("test.world:1:")
                .contains("'joules'");
        assertThat(warnings(scene).getLast())
                .asString()
                .startsWith("test.world:2:")
                .contains("'give_watts'");
    }

    @Test
    void transducersThatDifferAreDevicesOfTheirOwn() {
        Scene scene = scene("""
                position ( ranger (
                  sensor ( pose [0.1 0.1 0 45] range [0 5] fov 15 )
                  sensor ( pose [0.1 -0.1 0 -45] range [0 5] fov 15 )
                  sensor ( pose [-0.1 0 0 180] range [0 2] )
                  sensor ( samples 5 fov 20 ) ) )
                """);
        assertThat(scene.robots().getFirst().model().sensors()).containsOnlyKeys("sonar", "sonar-2", "laser");
        var front = (Part.Sonars) part(scene, "sonar");
        assertThat(front.baseFromSensors()).hasSize(2);
        assertThat(front.baseFromSensors().getFirst().theta()).isCloseTo(Math.PI / 4, within(1e-9));
        assertThat(((Part.Sonars) part(scene, "sonar-2")).rangeMax()).isEqualTo(2);
        assertThat(((Part.Laser) part(scene, "laser")).samples()).isEqualTo(5);
    }

    @Test
    void whatCanNotBeSimulatedIsLeftOutWithOneWarning() {
        Scene scene = scene("""
                define blind position ( ranger ( sensor ( range [0 0] ) ) )
                blind ( ) blind ( pose [2 0 0 0] ) blind ( pose [4 0 0 0] )
                """);
        assertThat(scene.robots())
                .hasSize(3)
                .allSatisfy(robot -> assertThat(robot.model().sensors()).isEmpty());
        assertThat(warnings(scene))
                .singleElement()
                .asString()
                .startsWith("test.world:1:")
                .contains("ignored", "range [m]");
    }

    @Test
    void robotsOfOneMakeShareTheirModel() {
        Scene scene = scene(CART + "cart ( ) cart ( pose [2 0 0 0] ) cart ( pose [4 0 0 0] fiducial ( ) )");
        var models = scene.robots().stream().map(RobotSpec::model).toList();
        assertThat(models.get(0)).isSameAs(models.get(1)).isNotSameAs(models.get(2));
    }

    @Test
    void basesOnThingsAreRobotsToo() {
        Scene scene = scene(
                "model ( name \"table\" size [2 2 0.7] pose [5 0 0 0] position ( name \"bot\" pose [1 0 0 0] ) )");
        assertThat(scene.robots()).singleElement().satisfies(robot -> {
            assertThat(robot.id()).isEqualTo("table.bot");
            assertThat(robot.mapFromBase().orElseThrow().x()).isCloseTo(6, within(1e-9));
        });
        assertThat(scene.robotBodies().get("table.bot").height()).isCloseTo(0.7, within(1e-9));
        assertThat(scene.things()).hasSize(1);
    }

    @Test
    void odometryStartsWhereTheWorldSaysAndDrifts() {
        Scene scene = scene("""
                position ( name "a" pose [1 1 0 0] localization "odom" localization_origin [3 0 0 0] odom_error [0.1 0 0 0.2] )
                position ( name "b" pose [4 1 0 0] localization "odom" )
                """);
        assertThat(scene.odomFromBase().get("a").x()).isEqualTo(3);
        assertThat(scene.odomFromBase().get("b").x()).isEqualTo(4);
        var noise = scene.robots().getFirst().model().drive().odometryNoise();
        assertThat(noise.distancePerMeter()).isEqualTo(0.1);
        assertThat(noise.headingPerRadian()).isEqualTo(0.2);
        assertThat(scene.robots().getLast().model().drive().odometryNoise().distancePerMeter())
                .isPositive();
    }

    @Test
    void randomColorsFollowFromTheSeed() {
        Worlds worlds = Worlds.of("model ( color \"random\" ) position ( color \"random\" pose [2 0 0 0] )");
        assertThat(scene(worlds, 5)).usingRecursiveComparison().isEqualTo(scene(worlds, 5));
        Rgb one = scene(worlds, 5)
                .things()
                .getFirst()
                .blocks()
                .getFirst()
                .surface()
                .color();
        Rgb other = scene(worlds, 6)
                .things()
                .getFirst()
                .blocks()
                .getFirst()
                .surface()
                .color();
        assertThat(one).isNotEqualTo(other);
    }

    @Test
    void theMapHasWhatStaysInTheWay() {
        Scene scene = scene("""
                model ( name "box" pose [1 1 0 0] size [0.5 0.5 0.5] )
                model ( name "puck" pose [3 1 0 0] size [0.5 0.5 0.5] gripper_return 1 )
                model ( name "zone" pose [5 1 0 0] size [0.5 0.5 0.02] obstacle_return 0 ranger_return -1 )
                model ( name "lamp" pose [7 1 2 0] size [0.5 0.5 0.5] )
                model ( name "glass" pose [9 1 0 0] size [0.5 0.5 0.5] obstacle_return 0 )
                position ( name "r" pose [11 1 0 0] )
                """);
        assertThat(occupied(scene, 1, 1)).isTrue();
        assertThat(occupied(scene, 3, 1)).isFalse();
        assertThat(occupied(scene, 5, 1)).isFalse();
        assertThat(occupied(scene, 7, 1)).isFalse();
        assertThat(occupied(scene, 9, 1)).isTrue();
        assertThat(occupied(scene, 11, 1)).isFalse();
        assertThat(scene.map().isFree(11.4, 1)).isTrue();
        assertThat(IntStream.range(0, scene.map().cells().length)
                        .filter(i -> scene.map().cells()[i] != 0))
                .hasSizeBetween(200, 250);
    }

    @Test
    void largeWorldsHaveCoarserMaps() {
        Scene scene = scene("model ( pose [1000 700 0 0] ) model ( )");
        assertThat(scene.map().cells()).hasSizeLessThan(16_100_000);
        assertThat(scene.map().resolution()).isGreaterThan(0.05);
        assertThat(occupied(scene, 1000, 700)).isTrue();
    }

    @Test
    void worldsWithoutEndAreRefused() {
        assertThatThrownBy(() -> scene("model ( pose [1000000 0 0 0] ) model ( )"))
                .isInstanceOf(InvalidSettings.class)
                .hasMessageContaining("m large")
                .hasMessageContaining("unit_length");
    }

    @Test
    void tenThousandRobotsOfAKindAreNotMuch() {
        var text = new StringBuilder(CART);
        for (int i = 0; i < 10_000; i++) {
            text.append("cart ( pose [%d %d 0 0] )%n".formatted(i % 100, i / 100));
        }
        Scene scene = scene(text.toString());
        assertThat(scene.robots()).hasSize(10_000);
        assertThat(scene.robots().stream()
                        .map(robot -> System.identityHashCode(robot.model()))
                        .distinct())
                .hasSize(1);
        assertThat(scene.robotBodies().values().stream()
                        .map(body -> System.identityHashCode(body.blocks()))
                        .distinct())
                .hasSize(1);
    }
}
