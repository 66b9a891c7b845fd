package rsal.stage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.scene.Scene;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.testkit.Trials;
import rsal.world.yaml.SceneWriter;
import rsal.world.yaml.YamlFormat;

/// A world of Stage that is written as one of our own is the same world.
class ConversionTest {
    private static final List<String> NUMBERS = List.of("0.0001", "0.5", "1500", "90000", "999999999");

    private static Scene stage(Worlds worlds) {
        return new StageFormat().read("test.world", worlds.source(), 1);
    }

    /// Written and read again.
    private static Scene converted(Scene scene) {
        SceneWriter.Written written = SceneWriter.write(scene, "test");
        FileSource files = (path, most, askedAt) -> {
            byte[] bytes = path.equals("test.world.yaml")
                    ? written.yaml().getBytes(StandardCharsets.UTF_8)
                    : written.images().get(path);
            if (bytes == null) {
                throw new InvalidSettings(askedAt, "There is no file '%s'.".formatted(path), "");
            }
            return bytes;
        };
        return new YamlFormat().read("test.world.yaml", files, 2);
    }

    private static void assertConverted(Scene scene) {
        SceneComparison.assertSame(converted(scene), scene);
    }

    @Test
    void boxesHaveTheNumbersThatTheirAuthorHadInMind() {
        Scene scene = stage(Worlds.of("""
                model ( size [12 10 1] boundary 1 )
                position ( size [0.455 0.381 0.237] origin [-0.04 0.01 0 0] )
                """));
        assertThat(SceneWriter.write(scene, "test").yaml())
                .contains("length: 12, width: 0.01, center: [0, 4.995]", "width: 0.381, center: [-0.04, 0.01]")
                .doesNotContainPattern("00000|99999");
        assertConverted(scene);
    }

    @Test
    void aBumperWithoutPadsIsOneInYamlToo() {
        Scene scene = stage(Worlds.of("position ( size [0.4 0.4 0.2] bumper ( ) )"));
        assertThat(scene.warnings())
                .singleElement()
                .asString()
                .startsWith("test.world:1:31: This bumper feels nothing");
        assertThat(converted(scene).warnings()).singleElement().asString().contains("feels nothing");
        assertConverted(scene);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "name \"hall: 1\" interval_sim 50 quit_time 30",
                "model ( name \"no: 1, {#}\" pose [1 2 0.5 77] size [2 1 0.4] color \"blue\" obstacle_return 0 )",
                "model ( give_watts 12.5 joules -1 )",
                """
                position ( fiducial ( ignore_zloc 1 ) gripper ( paddle_state [ "closed" "up" ] autosnatch 1 )
                  ranger ( sensor ( fov 180 samples 181 noise [0.0004 0.05 33] ) sensor ( noise [0.01 0.1 90] ) ) )
                """,
                "model ( ranger_return 0.5 blob_return 0 fiducial_return 7 fiducial_key 3 gripper_return 1 )",
                "model ( size [4 4 1] boundary 1 pose [0.1 0.2 0 33.3] )",
                """
                model ( block ( points 3 point[0] [0 0] point[1] [1 0] point[2] [0 1] z [0.1 0.7] color "green" )
                        block ( points 2 point[0] [0 0] point[1] [3 1] ) size [1 1 1] color "red" )
                """,
                """
                define cart position ( size [0.4 0.3 0.2] origin [-0.05 0 0 0]
                  ranger ( pose [0.1 0 0 10] sensor ( range [0.1 8] fov 270 samples 271 noise [0.001 0 0] ) )
                  ranger ( sensor ( pose [0.1 0.1 0 37] ) sensor ( pose [0.1 -0.1 0 -37] ) sensor ( range [0 3] ) ) )
                cart ( name "r0" pose [-2 0 0 33] ctrl "wander" color "random" )
                cart ( name "r1" pose [2 0 0 180] color "blue" localization "odom" localization_origin [1 2 0 30] )
                cart ( name "r2" pose [2 2 0.1 270] color "yellow" ctrl "other" )
                """,
                """
                position ( drive "omni" velocity_bounds [-1 2 -0.5 0.5 0 0 -77 90]
                  acceleration_bounds [-1.1 0.9 -1 1 0 0 -45 45] localization "odom" odom_error [0.02 0.02 0 0.05]
                  blobfinder ( colors_count 2 colors [ "red" "green" ] image [60 20] fov 70 range 7 pan 11 )
                  fiducial ( range_max 5 range_max_id 3 fov 123 fiducial_key 2 )
                  gripper ( pose [0.2 0 0 0] size [0.2 0.3 0.1 ] )
                  bumper ( bcount 2 bpose[0] [0.2 0 0 0] bpose[1] [-0.2 0 0 180] blength 0.3 )
                  actuator ( type "rotational" min_position -50 max_position 50 max_speed 30 start_position 7 )
                  blinkenlight ( period 500 dutycycle 0.3 ) joules 1000 joules_capacity 4000 take_watts 3 )
                position ( drive "car" wheelbase 0.7 actuator ( axis [1 1 0] ) )
                """,
                """
                position ( actuator ( noblocks 1 type "rotational" pose [0.1 0.05 0 33] start_position 0.3 max_speed 50
                    actuator ( noblocks 1 axis [1 2 3] min_position -0.5 start_position 0.25
                      ranger ( pose [0.1 0 0 10] sensor ( samples 5 ) sensor ( ) ) gripper ( ) fiducial ( ) )
                    bumper ( bcount 1 bpose[0] [0.2 0 0 0] blength 0.3 ) )
                  blobfinder ( ) )
                """,
                """
                position ( name "r" size [0.5 0.5 0.3] actuator ( type "rotational" max_position 90 size [0.3 0.1 0.1]
                  model ( pose [0.3 0 -0.1 0] size [0.3 0.05 0.05] color "blue" )
                  actuator ( noblocks 1 axis [0 0 1] model ( size [0.1 0.1 0.1] obstacle_return 0 ) ) ) )
                position ( noblocks 1 actuator ( ) )
                """,
                "position ( localization \"odom\" odom_error [999999 999999 0 999999] )",
                "define a position ( ) a ( ranger ( sensor ( samples 5 ) ) ) a ( ranger ( sensor ( samples 7 ) ) ) a ( )"
            })
    void whatIsThereStays(String world) {
        assertConverted(stage(Worlds.of(world)));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "position ( joules 100 take_watts %s )",
                "position ( joules 100 give_watts %s )",
                "position ( joules 100 take_watts %1$s give_watts %1$s watts %1$s model ( take_watts %1$s watts %1$s ) )",
                "position ( joules %s )",
                "position ( kjoules_capacity %s )",
                "position ( joules 100 mass %s )",
                "model ( give_watts %s )"
            })
    void energiesOfAnySizeStay(String world) {
        for (String number : NUMBERS) {
            assertConverted(stage(Worlds.of(world.formatted(number))));
        }
    }

    /// Those of our own worlds are for what can be built, and say of what else there is where it stands.
    @ParameterizedTest
    @ValueSource(
            strings = {
                "position ( velocity_bounds [-%1$s %1$s -%1$s %1$s 0 0 -%1$s %1$s] )",
                "position ( acceleration_bounds [-%1$s %1$s -%1$s %1$s 0 0 -%1$s %1$s] )",
                "position ( drive \"car\" wheelbase %s )",
                "position ( localization \"odom\" odom_error [%1$s %1$s 0 %1$s] )",
                "position ( ranger ( sensor ( range [0 %s] ) ) )",
                "position ( ranger ( sensor ( samples 5 range [0 %1$s] noise [%1$s 0 0] ) ) )",
                "position ( ranger ( sensor ( samples 5 noise [0 %s 0] ) ) )",
                "position ( blobfinder ( range %s ) )",
                "position ( fiducial ( range_max %1$s range_max_id %1$s ) )",
                "position ( gripper ( size [%1$s %1$s %1$s] ) )",
                "position ( bumper ( bcount 1 bpose[0] [0 0 0 0] blength %s ) )",
                "position ( actuator ( max_speed %1$s min_position -%1$s max_position %1$s ) )",
                "position ( blinkenlight ( period %s ) )",
                "position ( update_interval %s ranger ( update_interval %1$s sensor ( samples 5 ) ) )",
                "position ( size [%1$s %1$s %1$s] )",
                "position ( pose [%1$s %1$s %1$s 0] )",
                "model ( size [%1$s %1$s %1$s] )",
                "model ( pose [%1$s %1$s %1$s 0] )",
                "model ( ranger_return %s )",
                "model ( fiducial_return %s )",
                "quit_time %s",
                "interval_sim %s"
            })
    void whateverIsReadIsConvertedOrRefusedWithItsPlace(String world) {
        for (String number : NUMBERS) {
            Scene scene;
            try {
                scene = stage(Worlds.of(world.formatted(number)));
            } catch (InvalidSettings _) {
                continue; // broken ones can't be converted
            }
            try {
                assertConverted(scene);
            } catch (InvalidSettings refusal) {
                assertThat(number).isNotEqualTo("0.5");
                assertThat(refusal.problems())
                        .allSatisfy(
                                problem -> assertThat(problem.location().line()).isPositive());
            }
        }
    }

    @Trials(
            value = {"0", "90", "180", "-90", "30"},
            landing = 4)
    void imagesStay(String degrees) {
        StringBuilder drawn = new StringBuilder();
        for (int row = 0; row < 101; row++) {
            for (int column = 0; column < 103; column++) {
                drawn.append((row * 31 + column * 17) % 16 == 0 ? '#' : '.');
            }
            drawn.append('\n');
        }
        Scene scene =
                stage(Worlds.of("model ( bitmap \"a.pgm\" size [20.3 17.1 0.8] pose [1.1 2.7 0.1 %s] color \"gray30\" )"
                                .formatted(degrees))
                        .andImage("a.pgm", drawn.toString()));
        assertThat(scene.walls()).hasSize(degrees.equals("30") ? 0 : 1);
        assertConverted(scene);
    }

    @Test
    void robotsOfOneMakeShareTheirModel() {
        Scene scene = stage(Worlds.of("""
                define cart position ( ranger ( sensor ( samples 5 ) ) )
                cart ( color "red" ) cart ( pose [3 0 0 0] color "blue" ) cart ( pose [6 0 0 0] color "random" )
                """));
        assertThat(SceneWriter.write(scene, "test").yaml())
                .containsOnlyOnce("type: laser")
                .doesNotContain("cart-2");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            [1 2 0 33]  | [1 2 0 33.000001]
            [3 0 0 0]   | [3.00000001 0 0 0]
            range [0 8] | range [0 8.00000001]
            fov 90      | fov 90.000001
            size [2 1 1] | size [2 1 1.00000001]
            "red"       | "green"
            blob_return 0 | blob_return 1
            "wander"    | "other"
            """)
    void theComparisonNoticesWhatDiffers(String what, String other) {
        String world = """
                model ( size [2 1 1] pose [1 2 0 33] color "blue" blob_return 0 )
                position ( pose [3 0 0 0] color "red" ctrl "wander" ranger ( sensor ( range [0 8] fov 90 samples 9 ) ) )
                """;
        assertThat(world).contains(what);
        Scene scene = stage(Worlds.of(world));
        Scene changed = stage(Worlds.of(world.replace(what, other)));
        assertThatThrownBy(() -> SceneComparison.assertSame(changed, scene)).isInstanceOf(AssertionError.class);
    }

    static List<Path> realWorlds() throws IOException {
        try (Stream<Path> all = Files.walk(Path.of(System.getProperty("rsal.worlds", ".")))) {
            return all.filter(path -> path.toString().endsWith(".world"))
                    .sorted()
                    .toList();
        }
    }

    @ParameterizedTest
    @MethodSource("realWorlds")
    @EnabledIfSystemProperty(named = "rsal.worlds", matches = ".+", disabledReason = "a folder of worlds to try")
    void realWorldsStay(Path world) {
        Scene scene;
        try {
            scene = new StageFormat().read(world.toString(), FileSource.disk(), 1);
        } catch (InvalidSettings _) {
            return; // broken ones can't be converted
        }
        assertConverted(scene);
    }
}
