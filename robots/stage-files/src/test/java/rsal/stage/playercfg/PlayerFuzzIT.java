package rsal.stage.playercfg;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
import rsal.scene.Scene;
import rsal.settings.InvalidSettings;
import rsal.testkit.Rounds;

/// Whatever is in a configuration, it is read or refused with a message, soon.
class PlayerFuzzIT {
    private static final String GOOD = """
            # robots and a map
            include "map.inc"
            unit_length "m"
            driver ( name "stage" plugin "stageplugin" provides ["simulation:0"] worldfile "yard.world" usegui no )
            define served driver ( name "stage" model "r0" )
            served ( provides [ "6665:position2d:0" "ranger:0"
                                "localhost:6665:gripper:0" ] )
            served ( provides "6666:position2d:0" model "r1" )
            driver ( name "amcl" provides ["localize:0"] requires ["odometry:::position2d:0" "laser:::map:0"]
                     odom_drift[0] [0.2 0 0] odom_drift[1] [0 0.2 0] alwayson 1 laser_pose [0.13 0 0]
                     init_pose [1 2 90] init_pose_var [1 1 360] )
            driver ( name "mapfile" provides ["map:1"] filename "yard.png" resolution 0.5 origin [-1 2] negate 1 )
            interface ( name "own" code 200 plugin "own" )
            """;
    private static final String MAP = """
            driver ( name "mapfile" provides ["map:0"] filename "yard.png" resolution 0.05 negate 0 origin [-1.5 -2] )
            """;
    private static final String WORLD = """
            define cart position ( ranger ( sensor ( samples 5 ) ) gripper ( ) )
            cart ( name "r0" ) cart ( name "r1" pose [3 0 0 0] )
            """;
    private static final String ODD = "()[]\"#\n\r\t .:-+0123456789eE_azAZ{},;=/'\\%\0\u0085\uFEFF\uD83D";
    private static final String[] WORDS = {
        "define",
        "include",
        "server",
        "driver",
        "interface",
        "served",
        "name",
        "provides",
        "requires",
        "plugin",
        "alwayson",
        "worldfile",
        "model",
        "odom_drift[0]",
        "unit_length",
        "unit_angle",
        "yes",
        "no",
        "true",
        "false",
        "(",
        ")",
        "(",
        ")",
        "[",
        "]",
        "\"stage\"",
        "\"amcl\"",
        "\"r0\"",
        "\"r1\"",
        "\"yard.world\"",
        "\"yard.png\"",
        "init_pose",
        "origin",
        "resolution",
        "\"test.cfg\"",
        "\"map.inc\"",
        "\"position2d:0\"",
        "\"6666:ranger:0\"",
        "\"key:::laser:1\"",
        "\"simulation:0\"",
        "\":::::\"",
        "\"::\"",
        "\"a:b:c:d:e:f:0\"",
        "\"position2d:99999999999\"",
        "\"\"",
        "\"",
        "0",
        "-1",
        "2.5",
        "1e9",
        "--",
        "# x\n",
        "\n",
        "[1 2 3]",
        "\"radians\""
    };

    @Test
    void theGoodOneIsGood() {
        Scene scene = configs(GOOD).read();
        assertThat(scene.robots()).hasSize(2);
        assertThat(scene.services()).hasSize(6);
        assertThat(scene.map().resolution()).isEqualTo(0.05);
    }

    @Test
    void aDamagedConfigurationIsReadOrRefused() {
        for (long seed = 0; seed < Rounds.of(187, 3000); seed++) {
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
            readOrRefuse("seed " + seed, configs(text.toString()));
        }
    }

    @Test
    void aSoupOfWordsIsReadOrRefused() {
        for (long seed = 0; seed < Rounds.of(250, 4000); seed++) {
            var random = new Random(seed);
            var text = new StringBuilder(random.nextBoolean() ? GOOD : "");
            int words = random.nextInt(120);
            for (int i = 0; i < words; i++) {
                text.append(WORDS[random.nextInt(WORDS.length)]).append(random.nextInt(8) == 0 ? "\n" : " ");
            }
            readOrRefuse("seed " + seed, configs(text.toString()));
        }
    }

    @Test
    void aConfigurationCutShortIsReadOrRefused() {
        for (int length = 0; length < GOOD.length(); length++) {
            readOrRefuse("cut to " + length, configs(GOOD.substring(0, length)));
        }
        for (int length = 0; length < MAP.length(); length++) {
            readOrRefuse("map cut to " + length, configs(GOOD).and("etc/map.inc", MAP.substring(0, length)));
        }
    }

    @Test
    void noiseIsReadOrRefused() {
        for (long seed = 0; seed < Rounds.of(125, 2000); seed++) {
            var bytes = new byte[new Random(seed).nextInt(300)];
            new Random(seed).nextBytes(bytes);
            readOrRefuse("seed " + seed, configs("").and(Configs.FILE, bytes));
        }
    }

    private static Configs configs(String text) {
        return Configs.of(text)
                .and("etc/map.inc", MAP)
                .and("etc/yard.world", WORLD)
                .and("etc/yard.png", "P2 3 2 255 0 128 255 255 255 0");
    }

    private static void readOrRefuse(String which, Configs configs) {
        try {
            assertThat(configs.read().services()).as(which).allSatisfy(service -> {
                assertThat(service.port()).as(which).isBetween(1, 65_535);
                assertThat(service.devices()).as(which).isNotEmpty();
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
