package rsal.stage.playercfg;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.entry;
import static org.assertj.core.api.Assertions.tuple;
import static org.assertj.core.api.Assertions.within;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.ServiceLoader;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.device.Navigator.Tolerance;
import rsal.robot.RobotSpec;
import rsal.scene.RobotService;
import rsal.scene.RobotService.Software;
import rsal.scene.Scene;
import rsal.settings.Problem;
import rsal.settings.Value;
import rsal.stage.WorldFiles;
import rsal.stage.WorldProblems;
import rsal.world.SceneFormat;

class PlayerFormatTest {
    /// Made like those of the thesis: simulated robots, and stand-ins of real ones.
    private static final String WORLD = """
            include "pioneer.inc"
            robot ( name "r0" pose [0 0 0 90] )
            robot ( name "r1" pose [2 0 0 90] )
            proxy ( name "r3" pose [4 0 0 90] )
            model ( name "box" pose [6 0 0 0] ranger ( sensor ( samples 5 ) ) )
            """;

    private static final String PIONEER = """
            define robot position (
              ranger ( sensor ( pose [0.1 0 0 0] ) sensor ( pose [-0.1 0 0 180] ) )
              ranger ( sensor ( samples 682 fov 240 range [0.02 5.6] ) )
              gripper ( ) blobfinder ( ) )
            define proxy position ( blobfinder ( ) )
            """;

    private static final String UHH = """
            driver
            (
              name "stage"
              provides ["simulation:0"]
              plugin "stageplugin"
              # load the named file into the simulator
              worldfile "../worlds/uhh1.world"
            )
            driver ( name "stage" provides ["position2d:0" "ranger:0" "ranger:1" "gripper:0"] model "r0" )
            driver
            (
              name "stage"
              provides ["6667:position2d:0" "6667:ranger:0" "6667:ranger:1" "6667:gripper:0"
                        "6667:blobfinder:0"]
              model "r1"
            )
            driver ( name "stage" provides ["6671:position2d:0" "6671:blobfinder:0"] model "r3" )
            driver ( name "rangertolaser" requires ["6665:ranger:1"] provides ["6665:laser:0"] )
            driver
            (
              name "mapfile"
              provides ["map:0"]
              filename "bitmaps/tams_compl_red_map.png"
              resolution 0.05 # meters per pixel
              origin [-31.475 -7.8 ]
            )
            """;

    /// From the thesis, list. A.3, without most of its comments.
    private static final String PLANNER = """
            driver
            (
              name "vfh"
              provides ["position2d:1"]
              requires ["6665:position2d:0" "6665:laser:0"]
              safety_dist_0ms 0.1
              safety_dist_1ms 0.4
              free_space_cutoff_1ms 1000000.0
              max_speed 0.4
              max_speed_narrow_opening 0.1
              distance_epsilon 0.2
              angle_epsilon 3
              escape_speed 0.1
              escape_time 5.0
              escape_max_turnrate 10
            )
            driver
            (
              name "amcl"
              provides ["localize:0" "position2d:2"]
              requires ["odometry::6665:position2d:0" "6665:laser:0" "laser::6665:map:0"]
              odom_init 0
              init_pose [-21.0 4.0 0]
              init_pose_var [3.0 3.0 360.0]
              #odom_drift[0] [0.2 0.0 0.0]
              laser_pose [0.13 0 0]
              laser_max_beams 50
              laser_range_max 5.6
              laser_range_bad 0.02
            )
            driver
            (
              name "wavefront"
              provides ["planner:0"]
              requires ["output:::position2d:1" "input:::position2d:2" "6665:map:0"]
              alwayson 1
              safety_dist 0.3
              distance_epsilon 0.4
              angle_epsilon 10
            )
            """;

    private static Configs configs(String text) {
        return Configs.of(text).and("worlds/uhh1.world", WORLD).and("worlds/pioneer.inc", PIONEER);
    }

    private static final String STAGE =
            "driver ( name \"stage\" plugin \"stageplugin\" provides [\"simulation:0\"] worldfile \"../worlds/uhh1.world\" )\n";

    @Test
    void isFound() {
        assertThat(ServiceLoader.load(SceneFormat.class).stream().map(ServiceLoader.Provider::get))
                .extracting(SceneFormat::suffix)
                .contains(".cfg", ".world");
    }

    @Test
    void theWorldOfItsStageDriverIsOpened() {
        Scene scene = configs(UHH).read();
        assertThat(scene.robots()).extracting(RobotSpec::id).containsExactly("r0", "r1", "r3");
        assertThat(scene.robots().getFirst().model().sensors()).containsKeys("laser", "sonar", "gripper");
        assertThat(scene.title()).isEqualTo("worlds/uhh1.world");
    }

    @Test
    void whatIsServedIsReported() {
        assertThat(configs(UHH).read().services())
                .extracting(
                        RobotService::driver,
                        RobotService::port,
                        RobotService::devices,
                        RobotService::needs,
                        RobotService::robot)
                .containsExactly(
                        tuple("stage", 6665, List.of("simulation:0"), List.of(), Optional.empty()),
                        tuple(
                                "stage",
                                6665,
                                List.of("position2d:0", "ranger:0", "ranger:1", "gripper:0"),
                                List.of(),
                                Optional.of("r0")),
                        tuple(
                                "stage",
                                6667,
                                List.of("position2d:0", "ranger:0", "ranger:1", "gripper:0", "blobfinder:0"),
                                List.of(),
                                Optional.of("r1")),
                        tuple("stage", 6671, List.of("position2d:0", "blobfinder:0"), List.of(), Optional.of("r3")),
                        tuple("rangertolaser", 6665, List.of("laser:0"), List.of("6665:ranger:1"), Optional.of("r0")),
                        tuple("mapfile", 6665, List.of("map:0"), List.of(), Optional.empty()));
    }

    @Test
    void whatStandsBehindItIsFound() {
        List<RobotService> services = configs(UHH + PLANNER.replace("odom_init 0", "odom_init 0 pf_max_samples 2000"))
                .read()
                .services();
        assertThat(services).extracting(RobotService::refusal).containsOnly(Optional.empty());
        assertThat(services.get(0).sources()).containsExactly(entry("simulation:0", RobotService.SIMULATION));
        assertThat(services.get(1).sources())
                .containsExactly(
                        entry("position2d:0", "base"),
                        entry("ranger:0", "sonar"),
                        entry("ranger:1", "laser"),
                        entry("gripper:0", "gripper"));
        assertThat(services.get(4).sources()).containsExactly(entry("laser:0", "laser"));
        assertThat(services.get(5).sources()).containsExactly(entry("map:0", RobotService.MAP));
        assertThat(services.get(6).sources()).containsExactly(entry("position2d:1", "navigator"));
        assertThat(services.get(7).sources())
                .containsExactly(entry("localize:0", "localizer"), entry("position2d:2", "localizer"));
        assertThat(services.get(8).sources()).containsExactly(entry("planner:0", "navigator"));
        assertThat(services.subList(6, 9)).extracting(RobotService::robot).containsOnly(Optional.of("r0"));
        Tolerance tolerance = services.get(8).tolerance();
        assertThat(tolerance.distance()).isEqualTo(0.4);
        assertThat(tolerance.angle()).isCloseTo(Math.toRadians(10), within(1e-9));
    }

    @Test
    void aDriverAtTwoPortsHasSomethingElseBehindTheSameIndex() {
        List<RobotService> services = configs(
                        STAGE + "driver ( name \"stage\" provides [\"6670:ranger:0\" \"6671:ranger:0\"] model \"r0\" )")
                .read()
                .services();
        assertThat(services.subList(1, 3))
                .extracting(RobotService::port, RobotService::sources)
                .containsExactly(tuple(6670, Map.of("ranger:0", "sonar")), tuple(6671, Map.of("ranger:0", "laser")));
    }

    @Test
    void whatRobotsNeedForItIsSetAsTheFileSays() {
        List<RobotService> services = configs(UHH + PLANNER.replace("odom_init 0", "odom_init 0 pf_max_samples 2000"))
                .read()
                .services();
        List<Software> software = services.stream()
                .flatMap(service -> service.software().stream())
                .toList();
        assertThat(software).extracting(Software::name).containsExactly("localizer", "navigator");
        assertThat(software).extracting(Software::driver).containsExactly("amcl", "navigator");
        assertThat(values(software.getFirst()))
                .containsOnly(
                        entry("maxParticles", 2000L),
                        entry("beams", 50L),
                        entry("initialDeviation", 3.0),
                        entry("initialAngleDeviation", 360.0));
        assertThat(values(software.getLast()))
                .containsOnly(
                        entry("controller.type", "vfh"),
                        entry("controller.safetyDist0ms", 0.1),
                        entry("controller.safetyDist1ms", 0.4),
                        entry("maxSpeed", 0.4),
                        entry("controller.maxSpeedNarrowOpening", 0.1),
                        entry("escapeSpeed", 0.1),
                        entry("escapeTime", 5.0),
                        entry("wallDistance", 0.3));
    }

    /// Our third is 2: with it, Player's own two would be refused, as would be a first of 4 alone.
    @Test
    void vfhHasNoMoreWeightsThanInPlayer() {
        assertThat(weighed("weight_desired_dir 5.0 weight_current_dir 3.0"))
                .contains(
                        entry("controller.weightDesiredDir", 5.0),
                        entry("controller.weightCurrentDir", 3.0),
                        entry("controller.weightPreviousDir", 0.0));
        assertThat(weighed("weight_desired_dir 4.0"))
                .contains(entry("controller.weightDesiredDir", 4.0), entry("controller.weightPreviousDir", 0.0));
        assertThat(weighed("max_speed 0.4")).doesNotContainKey("controller.weightPreviousDir");
    }

    private static Map<String, Object> weighed(String options) {
        return values(configs(UHH + PLANNER.replace("max_speed 0.4", options)).read().services().stream()
                .flatMap(service -> service.software().stream())
                .toList()
                .getLast());
    }

    private static Map<String, Object> values(Software software) {
        var values = new LinkedHashMap<String, Object>();
        note("", software.settings(), values);
        return values;
    }

    /// @param group its name with a point
    private static void note(String group, Value.Mapping settings, Map<String, Object> values) {
        settings.entries().forEach((name, value) -> {
            if (value instanceof Value.Mapping own) {
                note(group + name + ".", own, values);
            } else {
                values.put(group + name, ((Value.Scalar) value).value());
            }
        });
    }

    @Test
    void optionsThatNothingHereHasAreOneWarningEach() {
        assertThat(configs(UHH + PLANNER).warnings())
                .anySatisfy(w -> assertThat(w).contains("'free_space_cutoff_1ms' has no effect"))
                .noneSatisfy(w -> assertThat(w).contains("'init_pose'"))
                .noneSatisfy(w -> assertThat(w).contains("'amcl' has no effect"))
                .noneSatisfy(w -> assertThat(w).contains("'distance_epsilon'"))
                .doesNotHaveDuplicates();
    }

    @ParameterizedTest
    @CsvSource(
            quoteCharacter = '`',
            delimiter = '|',
            value = {
                "driver ( name \"p2os\" provides [\"odometry:::position2d:0\"] ) | 2:1 | 'p2os' can't be served | It is for real robots.",
                "driver ( name \"wonder\" plugin \"w\" provides [\"log:0\"] ) | 2:1 | 'wonder' can't be served | ",
                "driver ( name \"vhf\" plugin \"w\" provides [\"log:0\"] ) | 2:1 | 'vhf' can't be served | Maybe 'vfh' was meant?",
                "driver ( name \"rangertolaser\" requires [\"ranger:7\"] provides [\"laser:0\"] ) | 2:1 | requires '6665:ranger:7', which no driver | include",
                "driver ( name \"vfh\" requires [\"a.b:6665:position2d:7\"] provides [\"position2d:0\"] ) | 2:1 | on another computer | one file",
                "driver ( name \"amcl\" provides [\"localize:0\"] ) | 2:1 | 'amcl' requires nothing | requires",
                "driver ( name \"stage\" provides [\"ranger:0\"] model \"r0\" ) driver ( name \"rangertolaser\" requires [\"ranger:0\"] provides [\"laser:0\"] ) | 2:58 | '6665:ranger:0', which is a 'sonar' and no 'laser' | another",
                "driver ( name \"stage\" provides [\"position2d:0\"] model \"r0\" ) driver ( name \"vfh\" requires [\"position2d:0\"] provides [\"position2d:1\"] ) driver ( name \"nd\" requires [\"position2d:0\"] provides [\"position2d:2\"] ) | 2:136 | Robot 'r0' has 'vfh' already, at etc/test.cfg:2:62 | one at most"
            })
    void whatCanNotBeOfferedSaysWhyAndWhere(String text, String at, String message, String remedy) {
        List<Problem> refusals = configs(STAGE + text).read().services().stream()
                .flatMap(service -> service.refusal().stream())
                .toList();
        assertThat(refusals).hasSize(1);
        assertThat(refusals.getFirst().toString())
                .startsWith("etc/test.cfg:" + at + ":")
                .contains(message)
                .contains(remedy == null ? "" : remedy);
    }

    @Test
    void whatHasNoEffectIsOneWarningEach() {
        List<String> warnings = configs(UHH).warnings();
        assertThat(warnings).hasSize(1);
        assertThat(warnings.getFirst())
                .startsWith("etc/test.cfg:19:1: The map is made of the world, as that of 'mapfile' can't be read: "
                        + "There is no file 'etc/bitmaps/tams_compl_red_map.png'.");
    }

    /// Three pixels wide, two high: black, gray, white over white, white, black.
    private static final String IMAGE = "P2 3 2 255 0 128 255 255 255 0";

    private static final String MAP_FILE = """
            driver ( name "mapfile" provides ["map:0"] filename "map.pgm" resolution 0.5 %s )
            """;

    private static OccupancyGrid map(String said) {
        Scene scene = configs(STAGE + MAP_FILE.formatted(said))
                .and("etc/map.pgm", IMAGE)
                .read();
        assertThat(scene.warnings()).extracting(Problem::toString).noneMatch(w -> w.contains("mapfile"));
        return scene.map();
    }

    @Test
    void theMapIsThatOfMapfile() {
        OccupancyGrid map = map("");
        assertThat(map.width()).isEqualTo(3);
        assertThat(map.height()).isEqualTo(2);
        assertThat(map.resolution()).isEqualTo(0.5);
        assertThat(map.originX()).as("its middle is at the origin").isEqualTo(-0.75);
        assertThat(map.originY()).isEqualTo(-0.5);
        assertThat(map.cells())
                .as("the lowest row first")
                .containsExactly(
                        OccupancyGrid.FREE,
                        OccupancyGrid.FREE,
                        OccupancyGrid.OCCUPIED,
                        OccupancyGrid.OCCUPIED,
                        OccupancyGrid.UNKNOWN,
                        OccupancyGrid.FREE);
        assertThat(map("negate 1").cells()[0]).isEqualTo(OccupancyGrid.OCCUPIED);
        OccupancyGrid placed = map("origin [-31.5 -7.8]");
        assertThat(placed.originX()).isEqualTo(-31.5);
        assertThat(placed.originY()).isEqualTo(-7.8);
        Scene centimeters = configs("unit_length \"cm\"\n" + STAGE + MAP_FILE.formatted("origin [-50 20]"))
                .and("etc/map.pgm", IMAGE)
                .read();
        assertThat(centimeters.map().resolution()).isEqualTo(0.005);
        assertThat(centimeters.map().originX()).isEqualTo(-0.5);
        assertThat(centimeters.walls())
                .as("what is solid stays")
                .isEqualTo(configs(STAGE).read().walls());
    }

    @Test
    void ofSeveralMapsTheFirstCounts() {
        String other = MAP_FILE.formatted("").replace("map:0", "map:1");
        Configs same = configs(STAGE + MAP_FILE.formatted("") + other).and("etc/map.pgm", IMAGE);
        assertThat(same.warnings()).noneMatch(w -> w.contains("mapfile"));
        Configs different = configs(STAGE + MAP_FILE.formatted("") + other.replace("0.5", "0.6"))
                .and("etc/map.pgm", IMAGE);
        assertThat(different.warnings()).anyMatch(w -> w.contains("This 'mapfile' serves the map of the first one"));
        assertThat(different.read().map().resolution()).isEqualTo(0.5);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "filename \"map.pgm\" | Its 'resolution' is not from 0.001 to 100 [m].",
                "filename \"map.pgm\" resolution -1 | Its 'resolution' is not from 0.001 to 100 [m].",
                "resolution 1 | It names no file.",
                "filename 7 resolution 1 | It names no file.",
                "filename \"map.pgm\" resolution 1 origin 7 | Its 'origin' is not a position.",
                "filename \"map.pgm\" resolution 1 origin [1] | Its 'origin' is not a position.",
                "filename \"test.cfg\" resolution 1 | it is neither a PGM"
            })
    void aMapThatCanNotBeReadIsMadeOfTheWorld(String said, String why) {
        Configs configs = configs(STAGE + "driver ( name \"mapfile\" provides [\"map:0\"] " + said + " )")
                .and("etc/map.pgm", IMAGE);
        assertThat(configs.warnings())
                .filteredOn(w -> w.contains("mapfile"))
                .singleElement()
                .satisfies(w -> assertThat(w).contains("The map is made of the world, as that of 'mapfile'", why));
        assertThat(configs.read().map())
                .usingRecursiveComparison()
                .isEqualTo(configs(STAGE).read().map());
    }

    @Test
    void amclStartsWhereItIsAskedTo() {
        assertThat(localizer(PLANNER).mapFromStart()).contains(new Pose2d(-21, 4, 0));
        assertThat(localizer(PLANNER.replace("init_pose [-21.0 4.0 0]", "")).mapFromStart())
                .as("where its robot does")
                .isEmpty();
        String turned = PLANNER.replace("init_pose [-21.0 4.0 0]", "init_pose [1 2 -90]")
                .replace("init_pose_var [3.0 3.0 360.0]", "");
        assertThat(localizer(turned).mapFromStart()).contains(Pose2d.ofDegrees(1, 2, -90));
        assertThat(values(localizer(turned)))
                .as("as uncertain as Player's")
                .contains(entry("initialDeviation", 1.0), entry("initialAngleDeviation", 360.0));
        String wrong = PLANNER.replace("init_pose [-21.0 4.0 0]", "init_pose [1 2]");
        assertThat(localizer(wrong).mapFromStart()).isEmpty();
        assertThat(configs(UHH + wrong).warnings())
                .anyMatch(w -> w.contains("'init_pose' has no effect: it is not a pose."));
    }

    private static Software localizer(String planner) {
        return configs(UHH + planner).read().services().stream()
                .flatMap(service -> service.software().stream())
                .filter(software -> software.name().equals("localizer"))
                .findFirst()
                .orElseThrow();
    }

    @Test
    void aConfigurationWithoutSimulationHasAnEmptyWorld() {
        Scene scene = Configs.of(PLANNER).read();
        assertThat(scene.robots()).isEmpty();
        assertThat(scene.services())
                .extracting(RobotService::driver, RobotService::devices, RobotService::needs)
                .containsExactly(
                        tuple("vfh", List.of("position2d:1"), List.of("6665:position2d:0", "6665:laser:0")),
                        tuple(
                                "amcl",
                                List.of("localize:0", "position2d:2"),
                                List.of("6665:position2d:0", "6665:laser:0", "6665:map:0")),
                        tuple(
                                "wavefront",
                                List.of("planner:0"),
                                List.of("6665:position2d:1", "6665:position2d:2", "6665:map:0")));
        assertThat(Configs.of(PLANNER).warnings())
                .hasSize(6)
                .anySatisfy(w ->
                        assertThat(w).startsWith("etc/test.cfg:26:3: 'laser_pose' is not known in a driver 'amcl'"))
                .anySatisfy(w -> assertThat(w).contains("'laser_range_max'", "asks the laser"))
                .anySatisfy(w -> assertThat(w).startsWith("etc/test.cfg:17:1: 'amcl' has no effect in a run."))
                .anySatisfy(w -> assertThat(w).contains("the world is empty"));
    }

    @Test
    void theGrammarIsReadIntoDrivers() {
        var findings = new WorldProblems();
        Configs configs = Configs.of("""
                include "more.inc"
                unit_length "cm"
                unit_angle "radians"
                define finder driver ( name "amcl" alwayson yes odom_drift[0] [0.2
                  0 0] )
                finder ( provides "localize:1" requires [ "odometry:::position2d:0" "host:7000:laser:2" ] )
                finder ( provides ["localhost:6670:localize:1"] alwayson false pf_err 0.5 )
                interface ( name "own" code 200 plugin "libown" )
                driver ( name "mine" plugin "libmine" provides ["key::7000:own:3"] speed [1 "a" true] )
                """).and("etc/more.inc", "driver ( name \"snd\" provides [\"position2d:4\"] )");
        PlayerConfig config = PlayerConfig.read(Configs.FILE, WorldFiles.in(configs.source()), findings);
        findings.throwIfAny();
        assertThat(findings.warnings(Configs.FILE)).isEmpty();
        assertThat(config.meters()).isEqualTo(0.01);
        assertThat(config.radians()).isEqualTo(1);
        assertThat(config.drivers()).extracting(Driver::name).containsExactly("snd", "amcl", "amcl", "mine");
        Driver first = config.drivers().get(1);
        assertThat(first.alwaysOn()).isTrue();
        assertThat(first.location().line()).isEqualTo(6);
        assertThat(first.option("odom_drift[0]")).isPresent();
        assertThat(first.requires().getFirst().key()).isEqualTo("odometry");
        assertThat(first.requires().getFirst().portOrUsual()).isEqualTo(6665);
        assertThat(first.requires().getLast().host()).isEqualTo("host");
        assertThat(first.requires().getLast().index()).isEqualTo(2);
        Driver second = config.drivers().get(2);
        assertThat(second.alwaysOn()).isFalse();
        assertThat(second.provides().getFirst().isHere()).isTrue();
        assertThat(second.options()).containsOnlyKeys("odom_drift[0]", "pf_err");
        Driver own = config.drivers().getLast();
        assertThat(own.plugin()).contains("libmine");
        assertThat(own.provides().getFirst().key()).isEqualTo("key");
        assertThat(own.provides().getFirst().device()).isEqualTo("own:3");
    }

    /// The thesis started `player -p 6666 planner1.cfg` and `player -p 6668 planner2.cfg` beside the world.
    @Test
    void includedFilesHaveAPortEach() {
        var findings = new WorldProblems();
        String planner = """
                driver ( name "amcl" provides ["localize:0"] requires ["odometry::%d:position2d:0"] )
                driver ( name "wavefront" provides ["planner:0"] requires ["localize:0"] )
                """;
        Configs configs = Configs.of("""
                        include "plan/planner1.cfg"
                        include "plan/planner2.cfg"
                        server ( file "planner1.cfg" port 6666 )
                        server ( file "plan/planner2.cfg" port 6668 )
                        driver ( name "mapfile" provides ["map:0"] )
                        """)
                .and("etc/plan/planner1.cfg", planner.formatted(6665))
                .and("etc/plan/planner2.cfg", planner.formatted(6667));
        PlayerConfig config = PlayerConfig.read(Configs.FILE, WorldFiles.in(configs.source()), findings);
        findings.throwIfAny();
        assertThat(config.drivers())
                .extracting(driver -> driver.provides().getFirst().place())
                .containsExactly(
                        "6666:localize:0", "6666:planner:0", "6668:localize:0", "6668:planner:0", "6665:map:0");
        assertThat(config.drivers())
                .flatExtracting(Driver::requires)
                .extracting(DriverAddress::place)
                .as("what names a port keeps it")
                .containsExactly("6665:position2d:0", "6666:localize:0", "6667:position2d:0", "6668:localize:0");
    }

    @ParameterizedTest
    @CsvSource(
            quoteCharacter = '`',
            delimiter = '|',
            value = {
                "server ( file \"p.cfg\" port 0 ) | A 'server' needs a 'file' and a 'port' from 1 to 65535.",
                "server ( file \"p.cfg\" port 66.5 ) | A 'server' needs a 'file' and a 'port'",
                "server ( port 6666 ) | A 'server' needs a 'file'",
                "server ( file \"q.cfg\" port 6666 ) | Nothing of 'q.cfg' is included here.",
                "server ( file \"p.cfg\" port 6666 ) server ( file \"p.cfg\" port 6667 ) | 'p.cfg' has two ports.",
            })
    void aServerThatMeansNothingIsRefused(String server, String message) {
        Configs configs = Configs.of("include \"p.cfg\"\n" + server)
                .and("etc/p.cfg", "driver ( name \"mapfile\" provides [\"map:0\"] )");
        assertThat(configs.errors()).anySatisfy(error -> assertThat(error).contains(message));
    }

    /// After a driver that simulates the world.
    @ParameterizedTest
    @CsvSource(
            quoteCharacter = '`',
            delimiter = '|',
            value = {
                "driver ( name \"stage\" provides [\"position2d:0\"] ) | 2:1 | does not say which 'model'",
                "driver ( name \"stage\" provides [\"position2d:0\"] model \"r9\" ) | 2:55 | Maybe 'r0' was meant?",
                "driver ( name \"stage\" provides [\"position2d:0\"] model 3 ) | 2:55 | There is no model '3'",
                "driver ( name \"stage\" provides [\"laser:0\"] model \"r0\" ) | 2:33 | rangertolaser",
                "driver ( name \"stage\" provides [\"imu:0\"] model \"r0\" ) | 2:33 | does not serve the interface 'imu'",
                "driver ( name \"stage\" provides [\"bumper:0\"] model \"r0\" ) | 2:33 | 'r0' has no model of type 'bumper' for 'bumper:0'",
                "driver ( name \"stage\" provides [\"position2d:0\" \"bumper:0\"] model \"r0\" ) | 2:48 | 'r0' has no model of type 'bumper' for 'bumper:0'",
                "driver ( name \"stage\" provides [\"gripper:0\" \"gripper:1\"] model \"r0\" ) | 2:45 | 'gripper' left for 'gripper:1'",
                "driver ( name \"stage\" provides [\"positon2d:0\"] model \"r0\" ) | 2:33 | Maybe 'position2d' was meant?",
                "driver ( name \"stage\" provides [\"position:0\"] model \"r0\" ) | 2:33 | Maybe 'position2d' was meant?",
                "driver ( name \"stage\" provides [\"position2d:0\"] model \"somebody\" ) | 2:55 | It has r0, r1, r3, box.",
                "driver ( name \"stage\" provides [\"position2d\"] model \"r0\" ) | 2:33 | is not a device",
                "driver ( name \"stage\" provides [\"position2d:x\"] model \"r0\" ) | 2:33 | is not a device",
                "driver ( name \"stage\" provides [\"0:position2d:0\"] model \"r0\" ) | 2:33 | is not a device",
                "driver ( name \"stage\" provides [3] model \"r0\" ) | 2:33 | 'provides' has '3', which is not a device",
                "driver ( name \"stage\" model \"r0\" ) | 2:1 | 'stage' provides nothing",
                "driver ( provides [\"position2d:0\"] model \"r0\" ) | 2:1 | has no 'name'",
                "driver ( name \"mapfile\" provides [\"map:0\" \"6665:map:0\"] ) | 2:43 | is provided twice; the first time at etc/test.cfg:2:35",
                "driver ( name \"mapfiel\" provides [\"map:0\"] ) | 2:10 | Maybe 'mapfile' was meant?",
                "drivr ( name \"mapfile\" provides [\"map:0\"] ) | 2:1 | Maybe 'driver' was meant?",
                "driver ( name \"mapfile\" provides [\"map:0\" ) | 2:34 | not closed",
                "driver ( name \"mapfile\" provides [\"map:0\"] | 2:8 | is not closed",
                "driver ( name mapfile provides [\"map:0\"] ) | 2:10 | 'name' has no value",
                "driver { name \"mapfile\" } | 2:8 | Maybe ( ) was meant?",
                "include \"none.inc\" | 2:1 | There is no file 'etc/none.inc'",
                "unit_length \"miles\" | 2:13 | 'unit_length' must be one of [m, cm, mm]"
            })
    void errorsAreReportedWithTheirPlace(String text, String at, String message) {
        assertThat(configs(STAGE + text).errors())
                .anySatisfy(m ->
                        assertThat(m).startsWith("etc/test.cfg:" + at + ":").contains(message));
    }

    @ParameterizedTest
    @CsvSource(
            quoteCharacter = '`',
            delimiter = '|',
            value = {
                "driver ( name \"stage\" provides [\"simulation:0\"] ) | 1:1 | names no 'worldfile'",
                "driver ( name \"stage\" provides [\"position2d:0\"] model \"r0\" ) | 1:1 | Put driver ( name \"stage\"",
                "driver ( name \"stage\" provides [\"simulation:0\"] worldfile \"no.world\" ) | 1:49 | There is no file 'etc/no.world'",
                "driver ( name \"stage\" provides [\"simulation:0\"] worldfile 3 ) | 1:49 | 'worldfile' names no file"
            })
    void withoutAWorldStageIsRefused(String text, String at, String message) {
        assertThat(configs(text).errors())
                .anySatisfy(m ->
                        assertThat(m).startsWith("etc/test.cfg:" + at + ":").contains(message));
    }

    @Test
    void errorsOfTheWorldAreReportedAsSuch() {
        assertThat(Configs.of(STAGE)
                        .and("worlds/uhh1.world", "model ( size [1 2] )")
                        .errors())
                .singleElement()
                .asString()
                .startsWith("worlds/uhh1.world:1:");
    }

    @ParameterizedTest
    @CsvSource(
            quoteCharacter = '`',
            delimiter = '|',
            value = {
                "driver ( name \"stage\" provides [\"position2d:0\"] model \"r0\" sped 3 ) | 2:60 | 'sped' is not known",
                "driver ( name \"stage\" provides [\"6667:simulation:0\"] worldfile \"x.world\" ) | 2:54 | the first one counts",
                "driver ( name \"stage\" provides [\"ranger:0\"] model \"box\" ) | 2:1 | 'box' is part of no robot",
                "driver ( name \"stage\" provides [\"position2d:0\" \"speech:0\"] model \"r0\" ) | 2:48 | 'speech:0' has no effect: robots here have nothing like it.",
                "driver ( name \"mapfile\" provides [\"map:0\"] resolutoin 3 ) | 2:44 | Maybe 'resolution' was meant?",
                "driver ( name \"wonder\" provides [\"log:0\"] a 3 ) | 2:1 | 'wonder' has no effect",
                "driver ( name \"p2os\" provides [\"odometry::position2d:0\"] ) | 2:32 | write (odometry:::position2d:0)",
                "driver ( name \"mapfile\" provides [\"map:0\"] block ( ) ) | 2:44 | 'block' has no effect in a driver",
                "resolution 3 | 2:1 | 'resolution' has no effect outside",
                "something ( ) | 2:1 | is neither a 'driver'"
            })
    void whatHasNoEffectIsAWarning(String text, String at, String message) {
        assertThat(configs(STAGE + text).warnings())
                .anySatisfy(w ->
                        assertThat(w).startsWith("etc/test.cfg:" + at + ":").contains(message));
    }

    @Test
    void stageWithoutItsPluginIsAWarning() {
        assertThat(configs(STAGE.replace("plugin \"stageplugin\"", "")).warnings())
                .singleElement()
                .asString()
                .contains("'plugin'");
    }
}
