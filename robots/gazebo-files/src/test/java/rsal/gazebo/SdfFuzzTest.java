package rsal.gazebo;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.scene.Scene;
import rsal.settings.InvalidSettings;
import rsal.testkit.Rounds;

/// Whatever is in a world file: it is read, or refused in words. It never hangs, nor throws anything else.
@Timeout(1800)
class SdfFuzzTest {
    private static final String GOOD = """
            <?xml version="1.0"?>
            <sdf version="1.9"><world name="yard">
            <frame name="gate" attached_to="a"><pose degrees="1">1 2 0 0 0 90</pose></frame>
            <model name="a"><static>true</static><pose>1 2 0.3 0 0 0.5</pose><link name="l"><pose relative_to="f">0 1 0 0 0 0</pose>
            <collision name="c"><geometry><box><size>1 2 0.6</size></box></geometry></collision>
            <visual name="c"><geometry><box><size>1 2 3</size></box></geometry><material><diffuse>1 0 0 1</diffuse></material></visual>
            </link><frame name="f"><pose>0 0 0 0 0 1</pose></frame></model>
            <model name="b" placement_frame="l"><pose relative_to="gate">-3 0 0 0 0.2 0</pose><link name="l"><collision name="c">
            <geometry><polyline><height>1</height><point>0 0</point><point>1 0</point><point>0 1</point></polyline></geometry></collision>
            <collision name="d"><geometry><mesh><uri>m.stl</uri><scale>1 1 2</scale></mesh></geometry></collision></link></model>
            <include merge="true"><uri>part.sdf</uri><name>p</name><pose relative_to="a::f">0 0 1 0 0 0</pose></include>
            <model name="r"><link name="base"><collision name="c"><geometry><cylinder><radius>0.2</radius><length>0.1</length>
            </cylinder></geometry></collision><sensor name="s" type="gpu_lidar"><update_rate>10</update_rate><lidar><scan><horizontal>
            <samples>90</samples><min_angle>-1</min_angle><max_angle>1</max_angle></horizontal></scan><range><min>0.1</min><max>5</max>
            </range></lidar></sensor></link><link name="w"/><joint name="j" type="revolute"><child>w</child><pose>0 0 0 0 0 0</pose></joint>
            <plugin filename="gz-sim-diff-drive-system" name="D"><left_joint>j</left_joint><max_velocity>1</max_velocity></plugin></model>
            <actor name="x"/></world></sdf>
            """;
    private static final String PART = """
            <sdf version="1.7"><model name="part"><link name="l"><collision name="c"><pose>0 0 0 1 0 0</pose><geometry><ellipsoid>
            <radii>0.1 0.2 0.3</radii></ellipsoid></geometry></collision></link><include><uri>part.sdf</uri></include></model></sdf>
            """.replace("<include><uri>part.sdf</uri></include>", "");
    private static final List<String> WORDS = List.of(
            "<model name=\"a\">",
            "</model>",
            "<pose>",
            "</pose>",
            "<pose relative_to=\"a\"/>",
            "<static>1</static>",
            "<include><uri>part.sdf</uri></include>",
            "<include><uri>worlds/test.sdf</uri></include>",
            "1e300",
            "-1e-300",
            "NaN",
            "1e999",
            "0",
            "-1",
            "<box/>",
            "<sphere><radius>0</radius></sphere>",
            "relative_to=\"__model__\"",
            "::",
            "&lt;",
            "&x;",
            "<!DOCTYPE a [<!ENTITY x \"y\">]>",
            "<![CDATA[",
            "]]>",
            "<frame name=\"g\" attached_to=\"g\"/>",
            "99999999999999999999",
            "<plane/>",
            "<capsule><radius>1</radius><length>2</length></capsule>",
            "0x1p3",
            "1d",
            "\"",
            "<",
            ">",
            "\uD83D",
            "\0");
    private static final String ODD = "<>\"'/=&;:.-+0123456789eE_azAZ \n\0\u0085\uFEFF";

    private static final byte[] STL =
            "solid x\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 1\n".getBytes(StandardCharsets.US_ASCII);

    @Test
    void theGoodOneIsGood() {
        Scene scene = worlds(GOOD).read();
        assertThat(scene.things()).hasSize(3);
        assertThat(scene.robots()).hasSize(1);
    }

    @Test
    void aDamagedWorldIsReadOrRefused() {
        for (long seed = 0; seed < Rounds.of(75, 10_000); seed++) {
            readOrRefuse("seed " + seed, worlds(damaged(seed)));
        }
    }

    /// The same without a map, which takes most of the time.
    @Test
    void aMillionOfThem() {
        for (long seed = 0; seed < Rounds.of(500, 1_000_000); seed++) {
            Worlds worlds = worlds(damaged(seed));
            try {
                new SdfWorldReader("worlds/test.sdf", new SdfFiles(worlds.source(), "worlds/test.sdf", Map.of()))
                        .read();
            } catch (InvalidSettings e) {
                assertThat(e.getMessage()).as("seed " + seed).isNotBlank();
            } catch (RuntimeException | StackOverflowError e) {
                throw new AssertionError("seed " + seed, e);
            }
        }
    }

    private static String damaged(long seed) {
        var random = new Random(seed);
        var text = new StringBuilder(GOOD);
        for (int change = random.nextInt(5); change >= 0; change--) {
            int at = random.nextInt(text.length());
            switch (random.nextInt(7)) {
                case 0 -> text.setCharAt(at, ODD.charAt(random.nextInt(ODD.length())));
                case 1 -> text.insert(at, ODD.charAt(random.nextInt(ODD.length())));
                case 2 -> text.delete(at, Math.min(text.length(), at + random.nextInt(20)));
                case 3 -> text.insert(at, WORDS.get(random.nextInt(WORDS.size())));
                case 4 -> replaceNumber(text, at, random);
                case 5 -> replaceName(text, at, random);
                default -> {
                    int begin = text.indexOf("<", at);
                    if (begin >= 0) {
                        text.insert(begin, WORDS.get(random.nextInt(WORDS.size())));
                    }
                }
            }
            text.append(' ');
        }
        return text.toString();
    }

    private static void replaceNumber(StringBuilder text, int from, Random random) {
        for (int at = from; at < text.length(); at++) {
            if (Character.isDigit(text.charAt(at))) {
                double number = random.nextGaussian() * Math.pow(10, random.nextInt(12) - 5);
                text.replace(at, at + 1, random.nextBoolean() ? Double.toString(number) : "" + random.nextInt(50));
                return;
            }
        }
    }

    private static void replaceName(StringBuilder text, int from, Random random) {
        int at = text.indexOf("name=\"", from);
        if (at >= 0) {
            text.replace(at + 6, at + 7, "" + (char) ('a' + random.nextInt(4)));
        }
    }

    @Test
    void aWorldCutShortIsReadOrRefused() {
        for (int length = 0; length < GOOD.length(); length += Rounds.of(67, 1)) {
            readOrRefuse("cut to " + length, worlds(GOOD.substring(0, length)));
        }
    }

    @Test
    void aDamagedMeshIsReadOrLeftOut() {
        for (long seed = 0; seed < Rounds.of(75, 10_000); seed++) {
            var random = new Random(seed);
            byte[] mesh = Arrays.copyOf(STL, random.nextInt(2 * STL.length));
            for (int i = random.nextInt(6); i > 0 && mesh.length > 0; i--) {
                mesh[random.nextInt(mesh.length)] = (byte) random.nextInt(256);
            }
            if (mesh.length >= 84 && random.nextBoolean()) {
                mesh[80] = (byte) ((mesh.length - 84) / 50);
            }
            readOrRefuse("seed " + seed, worlds(GOOD).and("worlds/m.stl", mesh));
        }
    }

    @Test
    void aDamagedColladaMeshIsReadOrLeftOut() {
        String world = GOOD.replace("m.stl", "m.dae");
        for (long seed = 0; seed < Rounds.of(75, 10_000); seed++) {
            var random = new Random(seed);
            byte[] mesh = ColladaMeshTest.TABLE.getBytes(StandardCharsets.UTF_8);
            for (int i = random.nextInt(6); i > 0; i--) {
                mesh[random.nextInt(mesh.length)] = (byte) (32 + random.nextInt(95));
            }
            readOrRefuse("seed " + seed, worlds(world).and("worlds/m.dae", mesh));
        }
    }

    private static Worlds worlds(String text) {
        return new Worlds()
                .and("worlds/test.sdf", text)
                .and("worlds/part.sdf", PART)
                .and("worlds/m.stl", STL);
    }

    private static void readOrRefuse(String which, Worlds worlds) {
        try {
            Scene scene = worlds.read();
            scene.things().forEach(thing -> {
                assertThat(thing.mapFromEntity().isFinite()).as(which).isTrue();
                assertThat(thing.height()).as(which).isFinite();
            });
            scene.robots()
                    .forEach(robot -> assertThat(
                                    robot.mapFromBase().orElseThrow().isFinite())
                            .as(which)
                            .isTrue());
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
