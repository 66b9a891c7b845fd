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
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.ActuatorState.Joint;
import rsal.data.Interval;
import rsal.data.LightState.Signal;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.model.RobotModels.Choice;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotModel.RangeNoise;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

class PartReaderTest {
    private static final Location HERE = new Location("hunt.yaml", 7, 12);
    private static final Map<String, String> DEVICES = Map.ofEntries(
            Map.entry("urg04lx", "laser"),
            Map.entry("utm30lx", "laser"),
            Map.entry("lds-01", "laser"),
            Map.entry("rplidar-a1", "laser"),
            Map.entry("lms111", "laser"),
            Map.entry("s300-ring", "laser"),
            Map.entry("robotino-ir", "sonar"),
            Map.entry("e-puck-ir", "sonar"),
            Map.entry("create3-bumper", "bumper"),
            Map.entry("front8", "sonar"),
            Map.entry("front8rear8", "sonar"),
            Map.entry("front8rear8dx", "sonar"),
            Map.entry("blob-camera", "camera"),
            Map.entry("fiducials180", "fiducials"),
            Map.entry("fiducials360", "fiducials"),
            Map.entry("pioneer-gripper", "gripper"),
            Map.entry("pioneer2dx-bumpers", "bumper"),
            Map.entry("turntable", "turntable"),
            Map.entry("pioneer-battery", "battery"),
            Map.entry("small-battery", "battery"),
            Map.entry("beacon", "light"),
            Map.entry("own-localizer", "localizer"),
            Map.entry("own-navigator", "navigator"),
            Map.entry("own-planner", "planner"),
            Map.entry("own-docking", "dock"),
            Map.entry("own-map", "map"),
            Map.entry("canvas", "canvas"));

    @TempDir
    private Path folder;

    private Part mounted(String device, String part) {
        return java.util.Objects.requireNonNull(new RobotModels(FileSource.folder(folder))
                .read("pioneer2dx", HERE, Map.of(device, new Choice(part, HERE)))
                .sensors()
                .get(device));
    }

    private Part part(String text) {
        try {
            Files.writeString(folder.resolve("part.yaml"), text);
        } catch (IOException e) {
            throw new AssertionError(e);
        }
        return mounted("camera", "part.yaml");
    }

    @ParameterizedTest
    @MethodSource("rsal.model.RobotModels#builtInParts")
    void everyPartThatComesAlongFitsAPioneer(String name) {
        assertThat(mounted(DEVICES.getOrDefault(name, "?"), name).name()).isEqualTo(name);
    }

    @Test
    void aPartIsWhereItIsMounted() {
        assertThat(part(BLOBS))
                .isEqualTo(new Part.BlobFinder(
                        "part.yaml",
                        new Pose2d(0.13, 0, 0),
                        80,
                        60,
                        Math.toRadians(60),
                        4,
                        List.of(new Rgb(255, 0, 0), new Rgb(0, 0, 255)),
                        Duration.ofMillis(200)));
        var pads = ((Part.Bumper) part(BUMPER)).pads();
        assertThat(pads)
                .containsExactly(
                        new Part.Bumper.Pad(new Pose2d(0.33, 0, 0), 0.4),
                        new Part.Bumper.Pad(Pose2d.ofDegrees(0.13, 0.2, 90), 0.1));
    }

    @Test
    void finderReadsIdsNoFartherThanItSees() {
        assertThat(part(FIDUCIALS))
                .isEqualTo(new Part.FiducialFinder(
                        "part.yaml", new Pose2d(0.13, 0, 0), Math.PI, 8, 5, 3, false, Duration.ofMillis(100)));
        assertThat(((Part.FiducialFinder) part(FIDUCIALS + "allHeights: true\n")).allHeights())
                .isTrue();
    }

    @Test
    void rangesAreOffAsTheirPartsSay() {
        String laser = """
                type: laser
                fieldOfView: 180
                samples: 181
                range: [0.1, 8]
                noise: 0.02
                period: 0.1
                """;
        assertThat(((Part.Laser) part(laser)).noise()).isEqualTo(RangeNoise.of(0.02));
        assertThat(((Part.Laser) part(laser + "relativeNoise: 0.01\nangularNoise: 90\n")).noise())
                .isEqualTo(new RangeNoise(0.02, 0.01, Math.PI / 2));
        assertRefused(laser + "relativeNoise: 1.5\n", "'relativeNoise' must be a number from 0.0 to 1.0");
        assertRefused(laser + "angularNoise: -1\n", "'angularNoise' must be a number from 0.0 to 180.0");
        String sonars = """
                type: sonars
                sensors: [[0, 0, 0]]
                fieldOfView: 15
                range: [0, 5]
                noise: 0.02
                period: 0.1
                """;
        assertThat(((Part.Sonars) part(sonars + "relativeNoise: 0.01\n")).noise())
                .isEqualTo(new RangeNoise(0.02, 0.01, 0));
        assertRefused(sonars + "angularNoise: 1\n", "angularNoise");
    }

    @Test
    void aGripperMayBeginClosedOrRaisedAndSnatch() {
        var usual = (Part.Gripper) part(GRIPPER);
        assertThat(usual.closed() || usual.raised() || usual.snatches()).isFalse();
        var other = (Part.Gripper) part(GRIPPER + "closed: true\nraised: true\nsnatches: true\n");
        assertThat(other.closed() && other.raised() && other.snatches()).isTrue();
        assertRefused(GRIPPER.replace("liftingTime: 2\n", "raised: true\n"), "it has no lift");
        assertRefused(GRIPPER + "closed: half\n", "'closed'");
    }

    @Test
    void aGripperHasALiftWhenItTakesTimeToLift() {
        var gripper = (Part.Gripper) part(GRIPPER);
        assertThat(gripper.hasLift()).isTrue();
        assertThat(gripper.opening()).isCloseTo(0.24, within(1e-12));
        assertThat(((Part.Gripper) part(GRIPPER.replace("liftingTime: 2\n", ""))).hasLift())
                .isFalse();
    }

    @Test
    void jointsAreInDegreesOrMeters() {
        var turns = (Part.Actuator) part(ACTUATOR);
        assertThat(turns.joint()).isEqualTo(Joint.ROTATIONAL);
        assertThat(turns.limits().most()).isCloseTo(Math.PI / 2, within(1e-12));
        assertThat(turns.maxSpeed()).isCloseTo(Math.PI / 6, within(1e-12));
        var slides = (Part.Actuator) part(ACTUATOR.replace("rotational", "linear"));
        assertThat(slides.limits()).isEqualTo(new Interval(-45, 90));
        assertThat(slides.home()).isEqualTo(10);
    }

    @Test
    void aBatteryIsFullUnlessItsFileSaysOtherwise() {
        var battery = (Part.Battery) part(BATTERY);
        assertThat(battery.charge()).isEqualTo(5000);
        assertThat(battery.energyPerRadian()).isCloseTo(0.5 * 180 / Math.PI, within(1e-9));
        assertThat(((Part.Battery) part(BATTERY + "charge: 10\n")).charge()).isEqualTo(10);
    }

    @Test
    void aLightHasASignal() {
        assertThat(part(LIGHT))
                .isEqualTo(new Part.Light(
                        "part.yaml",
                        new Pose2d(0.13, 0, 0),
                        new Rgb(0, 255, 0),
                        new Signal(Duration.ofMillis(500), 0.25),
                        Duration.ofMillis(100)));
    }

    @ParameterizedTest
    @ValueSource(strings = {BLOBS, FIDUCIALS, GRIPPER, BUMPER, ACTUATOR, BATTERY, LIGHT})
    void nothingMayBeLeftOutMisspelledOrAdded(String good) {
        for (String line : good.lines().toList()) {
            String key = line.substring(0, line.indexOf(':'));
            if (!List.of("colors", "key", "liftingTime").contains(key)) {
                assertRefused(good.replace(line + "\n", ""), key);
            }
            String mend = key.equals("type") ? "'type' is missing" : "Maybe '" + key + "' was meant?";
            assertRefused(good.replace(line, line.replace(key + ":", key + "x:")), mend);
            assertRefused(good.replace(line, key + ": {}"), key);
        }
    }

    @ParameterizedTest
    @CsvSource(
            quoteCharacter = '`',
            delimiter = '|',
            value = {
                "type: blob-finder | type: blobfinder | Maybe 'blob-finder' was meant?",
                "image: [80, 60] | image: [80, 0] | such as [80, 60]",
                "image: [80, 60] | image: [80.5, 60] | such as [80, 60]",
                "fieldOfView: 60 | fieldOfView: 400 | 'fieldOfView' must be a number from 0.001 to 360.0",
                "range: 4 | range: [0, 4] | 'range' must be a number",
                "`#0000ff` | bleu | 'colors' must be a color",
                "idRange: 5 | idRange: 9 | 'idRange' must be a number from 0.0 to 8.0",
                "key: 3 | key: 3.5 | 'key' must be a whole number",
                "paddleWidth: 0.03 | paddleWidth: 0.2 | 'paddleWidth'",
                "paddleLength: 0.1 | paddleLength: 0.3 | 'paddleLength'",
                "[0.2, 0, 0, 0.4] | [0.2, 0, 0] | a list of 4 numbers",
                "[0.2, 0, 0, 0.4] | [0.2, 0, 0, 0] | length must be positive",
                "joint: rotational | joint: rotationel | Maybe 'rotational' was meant?",
                "limits: [-45, 90] | limits: [90, -45] | 'limits' must be [least, most]",
                "home: 10 | home: 91 | 'home' must be a number from -45.0 to 90.0",
                "capacity: 5000 | capacity: 0 | 'capacity'",
                "idlePower: 20 | idlePower: -1 | 'idlePower'",
                "color: '#00ff00' | color: greem | 'color' must be a color, \"#rrggbb\" or a name, not 'greem'",
                "dutyCycle: 0.25 | dutyCycle: 25 | 'dutyCycle' must be a number from 0.0 to 1.0"
            })
    void whatMakesNoSenseIsRefused(String from, String to, String message) {
        String good = List.of(BLOBS, FIDUCIALS, GRIPPER, BUMPER, ACTUATOR, BATTERY, LIGHT).stream()
                .filter(text -> text.contains(from))
                .findFirst()
                .orElseThrow();
        assertRefused(good.replace(from, to), message);
    }

    @Test
    void listsThatAreMissingAreReportedAsMissing() {
        String bumpers = BUMPER.lines()
                .filter(line -> line.startsWith("bumpers"))
                .findFirst()
                .orElseThrow();
        assertRefused(BUMPER.replace(bumpers, ""), "'bumpers' is missing: a list of [x, y, heading, length].");
    }

    private void assertRefused(String text, String message) {
        assertThatExceptionOfType(InvalidSettings.class)
                .as(text)
                .isThrownBy(() -> part(text))
                .withMessageContaining(message);
    }

    private static final String BLOBS = """
            type: blob-finder
            image: [80, 60]
            fieldOfView: 60
            range: 4
            colors: ['#ff0000', '#0000ff']
            period: 0.2
            """;
    private static final String FIDUCIALS = """
            type: fiducial-finder
            fieldOfView: 180
            range: 8
            idRange: 5
            key: 3
            period: 0.1
            """;
    private static final String GRIPPER = """
            type: gripper
            length: 0.2
            width: 0.3
            height: 0.15
            paddleLength: 0.1
            paddleWidth: 0.03
            closingTime: 1
            liftingTime: 2
            period: 0.1
            """;
    private static final String BUMPER = """
            type: bumper
            bumpers: [[0.2, 0, 0, 0.4], [0, 0.2, 90, 0.1]]
            period: 0.1
            """;
    private static final String ACTUATOR = """
            type: actuator
            joint: rotational
            limits: [-45, 90]
            maxSpeed: 30
            home: 10
            period: 0.1
            """;
    private static final String BATTERY = """
            type: battery
            capacity: 5000
            idlePower: 20
            energyPerMeter: 30
            energyPerDegree: 0.5
            chargingPower: 100
            period: 0.1
            """;
    private static final String LIGHT = """
            type: light
            color: '#00ff00'
            flashPeriod: 0.5
            dutyCycle: 0.25
            period: 0.1
            """;
}
