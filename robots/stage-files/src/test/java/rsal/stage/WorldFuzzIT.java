package rsal.stage;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.settings.InvalidSettings;
import rsal.settings.Problem;
import rsal.testkit.Rounds;

/// Whatever is in a world file: it is read, or refused in words. It never hangs, nor throws anything else.
@Timeout(300)
class WorldFuzzIT {
    private static final String GOOD = """
            include "parts.inc" # what robots are made of
            name "Yard"
            unit_length "m"
            unit_angle "degrees"
            interval_sim 50
            window ( size [600 400] scale 30.5 show_data 1 )
            define wall model ( color "gray30" boundary 1 obstacle_return 1 ranger_return 0.5 )
            wall ( name "yard" bitmap "yard.pgm" size [16 12 0.8] )
            define cart position (
              size [0.4 0.3 0.2] origin [-0.05 0 0 0] drive "diff" mass 12.5
              localization "odom" odom_error [0.02 0.02 0 0.05]
              velocity_bounds [-0.5 0.5 0 0 0 0 -90 90]
              block ( points 4 point[0] [0 0] point[1] [2 0] point[2] [2 1] point[3] [0 1] z [0 1] color "blue" )
              sonars ( pose [0 0 -0.03 0] )
            )
            cart ( name "r0" pose [-2 1.5 0 45] laser ( ) gripper ( pose [0.2 0 0 0] paddle_state ["open" "up"] ) )
            cart ( pose [2 -1.5 0 -45] color "random" ctrl "wander" kjoules 40 fiducial ( range_max 5 )
                   blobfinder ( colors_count 2 colors [ "red" "green" ] ) bumper ( bcount 1 bpose[0] [0 0 0 0] ) )
            model ( pose [3 3 0 0] actuator ( axis [1 0 0] camera ( ) ) blinkenlight ( period 500 ) )
            """;
    private static final String PARTS = """
            define sonar sensor ( range [0 5] fov 15 samples 1 noise [0 0.01 0] )
            define sonars ranger ( sonar ( pose [0.1 0.1 0 45] ) sonar ( pose [0.1 -0.1 0 -45] ) )
            define laser ranger ( sensor ( range [0 8] fov 180 samples 181 ) block ( points 3 point[0] [0 0]
              point[1] [1 0] point[2] [0 1] ) )
            """;
    private static final String ODD = "()[]\"#\n\r\t .-+0123456789eE_azAZ{},;=:'\\%\0\u0085\uFEFF\uD83D";
    private static final String[] WORDS = {
        "define",
        "include",
        "model",
        "position",
        "ranger",
        "sensor",
        "block",
        "window",
        "laser",
        "sonars",
        "cart",
        "wall",
        "points",
        "point[0]",
        "point[1]",
        "z",
        "pose",
        "size",
        "origin",
        "name",
        "color",
        "bitmap",
        "boundary",
        "range",
        "samples",
        "fov",
        "noise",
        "mass",
        "(",
        ")",
        "(",
        ")",
        "[",
        "]",
        "\"yard.pgm\"",
        "\"parts.inc\"",
        "\"test.world\"",
        "\"red\"",
        "\"",
        "0",
        "1",
        "-1",
        "3",
        "2.5",
        "1e9",
        "1e-9",
        "--",
        "999999999",
        "# x\n",
        "\n",
        "[1 2 3 4]",
        "[1 2 3]",
        "[0 1]",
        "unit_length",
        "\"cm\"",
        "gripper",
        "bumper",
        "bcount",
        "kjoules",
        "a",
        "b"
    };

    @Test
    void theGoodOneIsGood() {
        StageWorld world = worlds(GOOD).read();
        assertThat(world.models()).hasSize(4);
        assertThat(world.warnings()).extracting(Problem::message).hasSize(1);
    }

    @Test
    void aDamagedWorldIsReadOrRefused() {
        for (long seed = 0; seed < Rounds.of(250, 4000); seed++) {
            var random = new Random(seed);
            var text = new StringBuilder(GOOD);
            for (int change = 0; change <= random.nextInt(6); change++) {
                int at = random.nextInt(text.length());
                char odd = ODD.charAt(random.nextInt(ODD.length()));
                switch (random.nextInt(6)) {
                    case 0 -> text.setCharAt(at, odd);
                    case 1 -> text.insert(at, odd);
                    case 2 -> text.delete(at, Math.min(text.length(), at + random.nextInt(20)));
                    case 3 -> text.insert(at, " " + WORDS[random.nextInt(WORDS.length)] + " ");
                    case 4 -> {
                        int end = Math.min(text.length(), at + random.nextInt(200));
                        text.insert(random.nextInt(text.length()), text.substring(at, end));
                    }
                    default -> text.insert(at, GOOD, 0, random.nextInt(GOOD.length()));
                }
                text.append(' ');
            }
            readOrRefuse("seed " + seed, worlds(text.toString()));
        }
    }

    @Test
    void aSoupOfWordsIsReadOrRefused() {
        for (long seed = 0; seed < Rounds.of(375, 6000); seed++) {
            var random = new Random(seed);
            var text = new StringBuilder(random.nextBoolean() ? "include \"parts.inc\"\n" : "");
            int words = random.nextInt(120);
            for (int i = 0; i < words; i++) {
                text.append(WORDS[random.nextInt(WORDS.length)]).append(random.nextInt(8) == 0 ? "\n" : " ");
            }
            readOrRefuse("seed " + seed, worlds(text.toString()));
        }
    }

    @Test
    void worldsGrownFromTheGrammarAreReadOrRefused() {
        for (long seed = 0; seed < Rounds.of(125, 2000); seed++) {
            var random = new Random(seed);
            var text = new StringBuilder("include \"parts.inc\"\n");
            for (int i = 0; i < 8; i++) {
                text.append("define a%d ".formatted(random.nextInt(4)));
                entity(text, random, 3);
            }
            for (int i = 0; i < 5; i++) {
                entity(text, random, 3);
            }
            readOrRefuse("seed " + seed, worlds(text.toString()));
        }
    }

    private static void entity(StringBuilder text, Random random, int depth) {
        String[] types = {"model", "position", "ranger", "sensor", "block", "gripper", "a0", "a1", "a2", "a3", "laser"};
        text.append(types[random.nextInt(types.length)]).append(" (\n");
        for (int i = random.nextInt(4); i > 0; i--) {
            String[] settings = {
                "pose [1 2 0 %d]", "size [%d 1 1]", "mass %d", "name \"n%d\"", "points %d", "point[0] [0 %d]",
                "point[1] [1 %d]", "samples %d", "z [0 %d]", "boundary %d", "noblocks %d", "joules %d",
                "origin [0 0 %d 0]", "color \"gray%d\"", "bcount %d", "blength %d"
            };
            text.append(settings[random.nextInt(settings.length)].formatted(random.nextInt(120) - 10))
                    .append('\n');
        }
        for (int i = depth == 0 ? 0 : random.nextInt(3); i > 0; i--) {
            entity(text, random, depth - 1);
        }
        text.append(")\n");
    }

    @Test
    void aWorldCutShortIsReadOrRefused() {
        for (int length = 0; length < GOOD.length(); length++) {
            readOrRefuse("cut to " + length, worlds(GOOD.substring(0, length)));
        }
        for (int length = 0; length < PARTS.length(); length++) {
            readOrRefuse("parts cut to " + length, worlds(GOOD).and("parts.inc", PARTS.substring(0, length)));
        }
    }

    @Test
    void noiseIsReadOrRefused() {
        for (long seed = 0; seed < Rounds.of(125, 2000); seed++) {
            var bytes = new byte[new Random(seed).nextInt(300)];
            new Random(seed).nextBytes(bytes);
            readOrRefuse("seed " + seed, worlds("").and("test.world", bytes));
            String text = GOOD + new String(bytes, StandardCharsets.ISO_8859_1);
            readOrRefuse("good and seed " + seed, worlds(text));
        }
    }

    @Test
    void aDamagedImageIsReadOrRefused() {
        byte[] image = "P5 # gray\n4 3\n255\nabcdefghijkl".getBytes(StandardCharsets.ISO_8859_1);
        for (long seed = 0; seed < Rounds.of(187, 3000); seed++) {
            var random = new Random(seed);
            byte[] damaged = Arrays.copyOf(image, random.nextInt(image.length) + 1);
            for (int i = random.nextInt(4); i > 0; i--) {
                damaged[random.nextInt(damaged.length)] = (byte) random.nextInt(256);
            }
            readOrRefuse("seed " + seed, worlds("model ( bitmap \"yard.pgm\" )").and("yard.pgm", damaged));
        }
    }

    private static Worlds worlds(String text) {
        return Worlds.of(text).and("parts.inc", PARTS).andImage("yard.pgm", "####\n#..#\n####");
    }

    private static void readOrRefuse(String which, Worlds worlds) {
        try {
            worlds.read().forEach(model -> {
                assertThat(model.name()).as(which).isNotEmpty();
                assertThat(model.worldFromModel().pose().isFinite()).as(which).isTrue();
                assertThat(model.traits().body().prisms())
                        .allSatisfy(prism -> assertThat(prism.outline())
                                .allSatisfy(c -> assertThat(Double.isFinite(c.x() + c.y()))
                                        .as(which)
                                        .isTrue()));
            });
        } catch (InvalidSettings e) {
            assertThat(e.problems()).as(which).isNotEmpty().allSatisfy(problem -> {
                assertThat(problem.message()).as(which).isNotBlank();
                assertThat(problem.location().file()).as(which).isNotEmpty();
            });
        } catch (RuntimeException | StackOverflowError e) {
            throw new AssertionError(which, e);
        }
    }
}
