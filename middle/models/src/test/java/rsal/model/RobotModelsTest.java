package rsal.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Footprint;
import rsal.data.Interval;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Prism;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.model.RobotModels.Choice;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Axis;
import rsal.robot.RobotModel.Drive;
import rsal.robot.RobotModel.OdometryNoise;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotModel.RangeNoise;
import rsal.robot.RobotModel.Steering;
import rsal.robot.RobotModel.Wheels;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

class RobotModelsTest {
    private static final Location HERE = new Location("hunt.yaml", 7, 12);

    @TempDir
    private Path folder;

    private RobotModels models;

    @BeforeEach
    void setUp() {
        models = new RobotModels(FileSource.folder(folder));
    }

    @ParameterizedTest
    @MethodSource("rsal.model.RobotModels#builtIn")
    void everyModelThatComesAlongCanBeRead(String name) {
        RobotModel model = models.read(name, HERE);
        assertThat(model.name()).isEqualTo(name);
        assertThat(model.footprint().inscribedRadius()).isBetween(0.01, 0.5);
        assertThat(RobotModels.source(name).orElseThrow()).startsWith("#");
    }

    /// As their makers publish them: the longest and the widest that they are [m], and how fast [m/s].
    @ParameterizedTest
    @CsvSource({
        "turtlebot3-burger, 0.138, 0.178, 0.22, laser",
        "turtlebot3-waffle, 0.281, 0.306, 0.26, laser",
        "turtlebot4, 0.342, 0.342, 0.306, laser bumper",
        "jackal, 0.508, 0.430, 2.0, laser",
        "husky, 0.990, 0.670, 1.0, laser",
        "amr-890, 0.890, 0.580, 1.5, laser",
        "robotino, 0.450, 0.450, 2.7, laser sonar",
        "e-puck, 0.070, 0.070, 0.154, sonar",
        "kilobot, 0.033, 0.033, 0.01, ''"
    })
    void theyAreAsTheirMakersSay(String name, double length, double width, double speed, String sensors) {
        RobotModel model = models.read(name, HERE);
        List<Point2d> outline = model.footprint().corners();
        assertThat(extent(outline, Point2d::x)).isCloseTo(length, within(0.005));
        assertThat(extent(outline, Point2d::y)).isCloseTo(width, within(0.005));
        assertThat(model.drive().maxSpeed()).isEqualTo(speed);
        assertThat(String.join(" ", model.sensors().keySet())).isEqualTo(sensors);
    }

    private static double extent(List<Point2d> outline, ToDoubleFunction<Point2d> coordinate) {
        var all = outline.stream().mapToDouble(coordinate).summaryStatistics();
        return all.getMax() - all.getMin();
    }

    @Test
    void aPioneer2dxIsAsLongAndWideAsTheRealOne() {
        RobotModel model = models.read("pioneer2dx", HERE);
        assertThat(model.title()).isEqualTo("Pioneer 2-DX");
        assertThat(model.footprint().inscribedRadius()).isCloseTo(0.18, within(1e-9)); // axis to front
        assertThat(model.footprint().circumscribedRadius()).isCloseTo(Math.hypot(0.26, 0.19), within(1e-9));
        assertThat(model.drive().maxTurnRate()).isCloseTo(Math.toRadians(300), within(1e-9));
        assertThat(model.sensors()).containsOnlyKeys("sonar");
    }

    @Test
    void aChosenLaserIsMountedWhereTheModelHasAPlaceForIt() {
        RobotModel model = models.read("pioneer2dx", HERE, Map.of("laser", new Choice("urg04lx", HERE)));
        assertThat(model.sensors()).containsOnlyKeys("sonar", "laser");
        assertThat(model.sensors().get("laser")).isInstanceOfSatisfying(Part.Laser.class, laser -> {
            assertThat(laser.baseFromLaser()).isEqualTo(new Pose2d(0.13, 0, 0));
            assertThat(laser.samples()).isEqualTo(682);
            assertThat(laser.angleMin()).isCloseTo(Math.toRadians(-120), within(1e-9));
            assertThat(laser.angleMin() + 681 * laser.angleIncrement()).isCloseTo(Math.toRadians(120), within(1e-9));
            assertThat(laser.rangeMax()).isEqualTo(5.6);
            assertThat(laser.period()).isEqualTo(Duration.ofMillis(100));
        });
    }

    @Test
    void sonarsSitOnTheBodyAndLookOutwards() {
        for (String name : List.of("pioneer2dx", "pioneer3at")) {
            var sonars = (Part.Sonars) models.read(name, HERE).sensors().get("sonar");
            double reach = models.read(name, HERE).footprint().circumscribedRadius();
            for (Pose2d sonar : sonars.baseFromSensors()) {
                assertThat(Math.hypot(sonar.x(), sonar.y()))
                        .as("%s %s", name, sonar)
                        .isBetween(0.1, reach);
                assertThat(sonar.y() * Math.sin(sonar.theta()))
                        .as("%s %s", name, sonar)
                        .isPositive();
            }
        }
    }

    @Test
    void aPartCanBeLeftOut() {
        RobotModel model = models.read("pioneer3at", HERE, Map.of("laser", new Choice(RobotModels.NO_PART, HERE)));
        assertThat(model.sensors()).containsOnlyKeys("sonar");
    }

    @Test
    void anUnknownModelIsRefusedWithAGuess() {
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> models.read("pioner2dx", HERE))
                .withMessageContaining("hunt.yaml:7:12")
                .withMessageContaining("There is no robot model 'pioner2dx'.")
                .withMessageContaining("Maybe 'pioneer2dx' was meant?");
    }

    @Test
    void anUnknownPartAndAnUnknownDeviceAreRefusedTogether() {
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> models.read(
                        "pioneer2dx",
                        HERE,
                        Map.of("laser", new Choice("urg04xl", HERE), "lasor", new Choice("x", HERE))))
                .satisfies(e -> assertThat(e.problems()).hasSize(2))
                .withMessageContaining("Maybe 'urg04lx' was meant?")
                .withMessageContaining("Robot model 'pioneer2dx' has no place for a device 'lasor'.")
                .withMessageContaining("Maybe 'laser' was meant?");
    }

    @Test
    void aPersonsOwnModelAndPartAreReadFromTheirFolder() throws IOException {
        write("cart.yaml", CART);
        write("eye.yaml", EYE);
        RobotModel cart = models.read("cart.yaml", HERE);
        assertThat(cart.title()).isEqualTo("Cart");
        assertThat(cart.sensors().get("eye"))
                .isEqualTo(new Part.Laser(
                        "eye.yaml",
                        new Pose2d(0.1, 0, 0),
                        Math.toRadians(-45),
                        Math.toRadians(45),
                        3,
                        0,
                        8,
                        RangeNoise.of(0),
                        Duration.ofMillis(50)));
    }

    @Test
    void devicesSitOnTopUnlessTheirMountSaysHowHigh() throws IOException {
        write("eye.yaml", EYE);
        write("cart.yaml", CART.replace("width: 0.2", "width: 0.2, height: 0.4"));
        assertThat(models.read("cart.yaml", HERE).height("eye")).isEqualTo(0.4);
        write("cart.yaml", CART.replace("eye: [0.1, 0, 0]", "eye: [0.1, 0, 0, 0.07]"));
        RobotModel cart = models.read("cart.yaml", HERE);
        assertThat(cart.height("eye")).isEqualTo(0.07);
        assertThat(cart.with(cart.drive()).height("eye")).isEqualTo(0.07);
    }

    @Test
    void aBodyIsABoxADiscOrAnOutline() throws IOException {
        write("eye.yaml", EYE);
        assertThat(body("length: 0.3, width: 0.2, height: 0.5"))
                .isEqualTo(Solid.standing(Shape.Polygon.of(Footprint.box(0.3, 0.2, new Point2d(0, 0))), 0.5));
        assertThat(body("radius: 0.2, center: [0.1, 0], color: '#ff0000'").pieces())
                .containsExactly(
                        new Prism(new Shape.Disc(new Point2d(0.1, 0), 0.2), 0, 0.25, Optional.of(new Rgb(255, 0, 0))));
        Solid arrow = body("outline: [[0.3, 0], [-0.2, 0.2], [-0.1, 0], [-0.2, -0.2]]");
        assertThat(((Shape.Polygon) arrow.pieces().getFirst().shape()).corners())
                .hasSize(4);
        assertThat(arrow.hull().corners()).hasSize(3);
    }

    @Test
    void aBodyMayHavePieces() throws IOException {
        write("eye.yaml", EYE);
        Solid body = body("pieces: [{radius: 0.2, height: 0.1}, {length: 0.1, width: 0.1, bottom: 0.1, height: 1}]");
        assertThat(body.pieces()).hasSize(2);
        assertThat(body.pieces().getLast().bottom()).isEqualTo(0.1);
        assertThat(body.top()).isEqualTo(1.1);
    }

    private Solid body(String text) throws IOException {
        write("cart.yaml", CART.replace("length: 0.3, width: 0.2", text));
        return models.read("cart.yaml", HERE).body();
    }

    @Test
    void aDriveIsDifferentialUnlessItsFileSaysOtherwise() throws IOException {
        write("eye.yaml", EYE);
        write("cart.yaml", CART);
        Drive drive = models.read("cart.yaml", HERE).drive();
        assertThat(drive).isEqualTo(new Drive(1, Math.PI / 2, 1, Math.PI / 2, new OdometryNoise(0, 0, 0)));
        assertThat(drive.symmetric()).isTrue();
    }

    @Test
    void anOmnidirectionalDriveHasItsOwnLimitsOnEachAxisAndWay() throws IOException {
        write("eye.yaml", EYE);
        write("cart.yaml", CART.replace("maxSpeed: 1", """
                type: omnidirectional
                  maxSpeed: [-0.5, 1.5]
                  maxSideSpeed: [0, 0.4]
                  maxSideAcceleration: 2"""));
        Drive drive = models.read("cart.yaml", HERE).drive();
        assertThat(drive.steering()).isEqualTo(new Steering.Omnidirectional());
        assertThat(drive.forward().speed()).isEqualTo(new Interval(-0.5, 1.5));
        assertThat(drive.maxSpeed()).isEqualTo(1.5);
        assertThat(drive.sideways()).isEqualTo(new Axis(new Interval(0, 0.4), Interval.around0(2)));
        assertThat(drive.symmetric()).isFalse();
    }

    @Test
    void aDifferentialDriveMayHaveWheels() throws IOException {
        write("eye.yaml", EYE);
        write("cart.yaml", CART);
        assertThat(models.read("cart.yaml", HERE).drive().steering()).isEqualTo(new Steering.Differential());
        write("cart.yaml", CART.replace("maxSpeed: 1", "maxSpeed: 1\n  wheels: {radius: 0.05, track: 0.3}"));
        assertThat(models.read("cart.yaml", HERE).drive().steering())
                .isEqualTo(new Steering.Differential(Optional.of(new Wheels(0.05, 0.3))));
    }

    @Test
    void aCarHasAWheelbaseAndASteeringAngle() throws IOException {
        write("eye.yaml", EYE);
        write("cart.yaml", CART.replace("maxSpeed: 1", """
                type: car
                  wheelbase: 0.5
                  maxSteeringAngle: 45
                  maxSpeed: 1"""));
        Drive drive = models.read("cart.yaml", HERE).drive();
        assertThat(drive.steering())
                .isInstanceOfSatisfying(
                        Steering.Car.class,
                        car -> assertThat(car.turningRadius()).isCloseTo(0.5, within(1e-9)));
        assertThat(drive.turnsInPlace()).isFalse();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "width: 0.2}|width: -1}",
                "width: 0.2}|width: .inf}",
                "width: 0.2}|width: 0.2, center: [1e300, 0]}",
                "length: 0.3|lenght: 0.3",
                "length: 0.3|length: 0.3, height: 0",
                "length: 0.3|length: 0.3, color: bleu",
                "length: 0.3|length: 0.3, radius: 0.2",
                "length: 0.3, width: 0.2|radius: 0",
                "length: 0.3, width: 0.2|radius: 0.2, center: [0]",
                "length: 0.3, width: 0.2|outline: []",
                "length: 0.3, width: 0.2|outline: 1",
                "length: 0.3, width: 0.2|outline: [[0, 0], [1, 0], [1]]",
                "length: 0.3, width: 0.2|outline: [[0, 0], [1, 1], [1, 0], [0, 1]]",
                "length: 0.3, width: 0.2|outline: [[0, 0], [1e9, 1], [1, 0]]",
                "length: 0.3, width: 0.2|pieces: []",
                "length: 0.3, width: 0.2|pieces: [{radius: 0.2, pieces: []}]",
                "length: 0.3, width: 0.2|pieces: [{radius: 0.2}], height: 1",
                "length: 0.3, width: 0.2|pieces: [1]",
                "length: 0.3|length: long",
                "maxSpeed: 1|maxSpeed: 0",
                "maxSpeed: 1|maxSpeed: [0.1, 1]",
                "maxSpeed: 1|maxSpeed: [-1, 0]",
                "maxSpeed: 1|maxSpeed: [-1, 1, 1]",
                "maxSpeed: 1|{maxSpeed: 1, type: tracked}",
                "maxTurnRate: 90|maxTurnRate: [0, 90]",
                "maxAcceleration: 1|maxAcceleration: [0, 1]",
                "maxSpeed: 1|maxSpeed: 1\n  type: omnidirectional",
                "maxSpeed: 1|maxSpeed: 1\n  type: car",
                "maxSpeed: 1|maxSpeed: 1\n  maxSideSpeed: 1",
                "maxSpeed: 1|maxSpeed: 1\n  wheelbase: 1",
                "maxSpeed: 1|maxSpeed: 1\n  wheels: {radius: 0.05}",
                "maxSpeed: 1|maxSpeed: 1\n  wheels: {radius: 0, track: 0.3}",
                "maxSpeed: 1|maxSpeed: 1\n  wheels: {radius: 0.05, track: 0.3, width: 0.02}",
                "maxSpeed: 1|maxSpeed: .nan",
                "eye: [0.1, 0, 0]|eye: [0.1, 0]",
                "eye: [0.1, 0, 0]|eye: [0.1, 0, 0, -1]",
                "eye: [0.1, 0, 0]|eye: [0.1, 0, 0, .inf]",
                "eye: eye.yaml|eye: ../eye.yaml",
                "eye: eye.yaml|eye: [1]",
                "title: Cart|titel: Cart"
            })
    void aWrongModelFileIsRefused(String change) throws IOException {
        String[] fromTo = change.split("\\|", 2);
        assertThat(CART).contains(fromTo[0]);
        write("eye.yaml", EYE);
        write("cart.yaml", CART);
        models.read("cart.yaml", HERE);
        write("cart.yaml", CART.replace(fromTo[0], fromTo[1]));
        assertThatExceptionOfType(InvalidSettings.class).isThrownBy(() -> models.read("cart.yaml", HERE));
    }

    @Test
    void theFilesInTheReferenceCanBeRead() throws IOException {
        String page = Files.readString(Path.of("../../docs/reference/robot-models.md"));
        List<String> files = Pattern.compile("```yaml\n(.*?)```", Pattern.DOTALL)
                .matcher(page)
                .results()
                .map(found -> found.group(1))
                .toList();
        assertThat(files).hasSize(2);
        write("cart.yaml", files.getFirst());
        write("camera.yaml", files.getLast());
        RobotModel cart = models.read("cart.yaml", HERE, Map.of("camera", new Choice("camera.yaml", HERE)));
        assertThat(cart.sensors()).containsOnlyKeys("laser", "battery", "camera");
        assertThat(PartReader.types())
                .allSatisfy(
                        type -> assertThat(page).containsPattern("(?m)^(\\| `" + type + "` \\||### " + type + "$)"));
    }

    private static String carrying(String mounts, String sensors) {
        return CART.substring(0, CART.indexOf("mounts")) + "mounts: {" + mounts + "}\nsensors: {" + sensors + "}\n";
    }

    @Test
    void aDeviceStandsOnTheActuatorThatItsMountNames() throws IOException {
        write("eye.yaml", EYE);
        write("cart.yaml", carrying("""
                arm: [0, 0, 0], table: {actuator: arm, pose: [0.1, 0, 0]},
                  eye: {actuator: table, pose: [0.2, 0, 90, 0.7]}, back: [0, 0, 180]""", """
                arm: turntable, table: turntable, eye: eye.yaml, back: eye.yaml"""));
        RobotModel cart = models.read("cart.yaml", HERE);
        assertThat(cart.carriers()).isEqualTo(Map.of("table", "arm", "eye", "table"));
        assertThat(cart.carriersOf("eye")).containsExactly("arm", "table");
        assertThat(cart.carriersOf("back")).isEmpty();
        assertThat(cart.height("eye")).isEqualTo(0.7);
        assertThat(((Part.Laser) cart.sensors().get("eye")).baseFromLaser()).isEqualTo(Pose2d.ofDegrees(0.2, 0, 90));
    }

    @Test
    void whereAnActuatorIsLeftOutItsLoadStandsOnWhatItWouldStandOn() throws IOException {
        write("eye.yaml", EYE);
        write("cart.yaml", carrying("""
                arm: [0, 0, 0], table: {actuator: arm, pose: [0.1, 0, 0]}, eye: {actuator: table, pose: [0.2, 0, 0]}""", """
                arm: turntable, table: turntable, eye: eye.yaml"""));
        var none = new Choice(RobotModels.NO_PART, HERE);
        assertThat(models.read("cart.yaml", HERE, Map.of("table", none)).carriers())
                .isEqualTo(Map.of("eye", "arm"));
        assertThat(models.read("cart.yaml", HERE, Map.of("table", none, "arm", none))
                        .carriers())
                .isEmpty();
    }

    @ParameterizedTest
    @CsvSource(quoteCharacter = '`', delimiter = '|', textBlock = """
            eye: {actuator: tabel, pose: [0, 0, 0]} | 'tabel', which 'mounts' does not list. | Maybe 'table' was meant?
            eye: {actuator: eye, pose: [0, 0, 0]}   | 'eye' stands on what stands on 'eye'.  | cart.yaml:10
            eye: {actuator: table}                  | 'mounts.eye.pose' is missing           | cart.yaml:10
            eye: {pose: [0, 0, 0]}                  | 'mounts.eye.actuator' is missing       | cart.yaml:10
            eye: {actuator: table, pose: [0, 0]}    | must be a list of 3 numbers            | cart.yaml:10
            eye: {actuator: table, pose: [0, 0, 0], on: 1} | is not known                    | cart.yaml:10
            eye: {actuator: back, pose: [0, 0, 0]}  | 'back', which is not an actuator           | Only actuators carry
            """)
    void whatCantCarryIsRefused(String mount, String message, String more) throws IOException {
        write("eye.yaml", EYE);
        write(
                "cart.yaml",
                carrying(
                        "table: [0, 0, 0], back: [0, 0, 0],\n  " + mount,
                        "table: turntable, back: eye.yaml, eye: eye.yaml"));
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> models.read("cart.yaml", HERE))
                .withMessageContaining(message)
                .withMessageContaining(more);
    }

    private static final String CART = """
            title: Cart
            body: {length: 0.3, width: 0.2}
            drive:
              maxSpeed: 1
              maxTurnRate: 90
              maxAcceleration: 1
              maxTurnAcceleration: 90
              odometryNoise: {distancePerMeter: 0, headingPerMeter: 0, headingPerDegree: 0}
            mounts: {eye: [0.1, 0, 0]}
            sensors: {eye: eye.yaml}
            """;

    private static final String EYE = """
            type: laser
            fieldOfView: 90
            samples: 3
            range: [0, 8]
            noise: 0
            period: 0.05
            """;

    private void write(String name, String text) throws IOException {
        Files.writeString(folder.resolve(name), text);
    }
}
