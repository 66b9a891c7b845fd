package rsal.world.yaml;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.scene.Scene;
import rsal.settings.InvalidSettings;
import rsal.testkit.LongTest;
import rsal.testkit.Rounds;

/// Whatever is in a world's file: it is read, or refused in words. It never hangs, nor throws anything else.
@Timeout(300)
class WorldFuzzIT {
    private static final String ODD = "[]{}\"'#\n\t :,-+.0123456789eE&*!|>%@`~?azAZ\0\u0085\uFEFF\uD83D";
    private static final String[] VALUES = {
        "0",
        "1",
        "-1",
        "1e9",
        "-1e-9",
        "1e308",
        ".inf",
        ".nan",
        "0.1",
        "\"\"",
        "true",
        "false",
        "[]",
        "{}",
        "[0, 0]",
        "[0, 0, 0]",
        "[[0, 0], [1, 0], [0, 1]]",
        "[1e6, -1e6, 1e6]",
        "a",
        "\"#ff0000\"",
        "a.pgm",
        "m.yaml",
        "hall.world.yaml",
        "pioneer2dx",
        "cart",
        "none",
        "{free: true}",
        "{first: [0, 0, 0], step: [1, 1]}",
        "{radius: 1}",
        "*a",
        "&a 1",
        "{pieces: []}",
        "{pieces: [{radius: 1}]}",
        "9223372036854775807",
        "1e400",
        "[[0, 0], [0, 0]]",
        "10000"
    };
    private static final String[] KEYS = {
        "rsal",
        "title",
        "step",
        "end",
        "area",
        "walls",
        "things",
        "fields",
        "models",
        "parts",
        "robots",
        "line",
        "closed",
        "thickness",
        "radius",
        "center",
        "length",
        "width",
        "outline",
        "image",
        "resolution",
        "size",
        "origin",
        "threshold",
        "fenced",
        "map",
        "bottom",
        "height",
        "pose",
        "body",
        "pieces",
        "color",
        "obstacle",
        "reflectance",
        "blob",
        "fiducial",
        "key",
        "grippable",
        "moves",
        "count",
        "density",
        "shapes",
        "colors",
        "gap",
        "robotGap",
        "seed",
        "model",
        "devices",
        "role",
        "program",
        "odometry",
        "drive",
        "mounts",
        "sensors",
        "type"
    };

    private final String good = Files.readString(Path.of("../../docs/examples/yard.world.yaml"))
            + "  seer: {model: m.yaml, pose: [-4, -3, 0]}\n";

    WorldFuzzIT() throws IOException {}

    private static Worlds worlds(String text) {
        return new Worlds()
                .and(Worlds.FILE, text.getBytes(StandardCharsets.UTF_8))
                .andImage("a.pgm", "##\n#.")
                .and("m.yaml", """
                        title: Mine
                        body: {radius: 0.2}
                        drive: {maxSpeed: 1, maxTurnRate: 90, maxAcceleration: 1, maxTurnAcceleration: 90,
                                odometryNoise: {distancePerMeter: 0, headingPerMeter: 0, headingPerDegree: 0}}
                        """);
    }

    @Test
    void theGoodOneIsGood() {
        assertThat(worlds(good).read().robots()).hasSize(5);
    }

    @Test
    void aDamagedWorldIsReadOrRefused() {
        for (long seed = 0; seed < Rounds.of(93, 1500); seed++) {
            var random = new Random(seed);
            var text = new StringBuilder(good);
            for (int change = 0; change <= random.nextInt(5); change++) {
                int at = random.nextInt(text.length());
                switch (random.nextInt(5)) {
                    case 0 -> text.setCharAt(at, ODD.charAt(random.nextInt(ODD.length())));
                    case 1 -> text.insert(at, ODD.charAt(random.nextInt(ODD.length())));
                    case 2 -> text.delete(at, Math.min(text.length(), at + random.nextInt(20)));
                    case 3 -> text.insert(at, VALUES[random.nextInt(VALUES.length)]);
                    default -> {
                        int end = Math.min(text.length(), at + random.nextInt(200));
                        text.insert(random.nextInt(text.length()), text.substring(at, end));
                    }
                }
                text.append(' ');
            }
            readOrRefuse("seed " + seed, worlds(text.toString()));
        }
    }

    /// Values of the good one, each replaced by something else: what is left is YAML.
    @Test
    void aWorldOfOtherValuesIsReadOrRefused() {
        for (long seed = 0; seed < Rounds.of(37, 600); seed++) {
            var random = new Random(seed);
            String[] words = good.split("(?<=[ ,:\\[\\]{}])|(?=[ ,:\\[\\]{}])", -1);
            for (int change = 0; change <= random.nextInt(4); change++) {
                int at = random.nextInt(words.length);
                if (words[at].matches("[a-zA-Z]+")) {
                    words[at] = KEYS[random.nextInt(KEYS.length)];
                } else if (words[at].matches("-?[0-9.]+")) {
                    words[at] = VALUES[random.nextInt(VALUES.length)];
                }
            }
            readOrRefuse("seed " + seed, worlds(String.join("", words)));
        }
    }

    @Test
    void aWorldGrownFromKeysIsReadOrRefused() {
        for (long seed = 0; seed < Rounds.of(250, 4000); seed++) {
            var random = new Random(seed);
            var text = new StringBuilder("rsal: 1\n");
            for (String section : List.of("walls", "things", "fields", "models", "robots")) {
                text.append(section).append(":\n");
                for (int i = random.nextInt(4); i >= 0; i--) {
                    text.append(section.equals("walls") ? "  - {" : "  a%d: {".formatted(i));
                    for (int k = random.nextInt(6); k > 0; k--) {
                        text.append(KEYS[11 + random.nextInt(KEYS.length - 11)])
                                .append(": ")
                                .append(VALUES[random.nextInt(VALUES.length)])
                                .append(", ");
                    }
                    text.append("}\n");
                }
            }
            readOrRefuse("seed " + seed, worlds(text.toString()));
        }
    }

    @Test
    void aWorldCutShortIsReadOrRefused() {
        for (int length = 0; length < good.length(); length += 3) {
            readOrRefuse("cut to " + length, worlds(good.substring(0, length)));
        }
    }

    @Test
    void noiseIsReadOrRefused() {
        for (long seed = 0; seed < Rounds.of(125, 2000); seed++) {
            var bytes = new byte[new Random(seed).nextInt(300)];
            new Random(seed).nextBytes(bytes);
            readOrRefuse("seed " + seed, worlds("").and(Worlds.FILE, bytes));
        }
    }

    @Test
    @LongTest
    void muchOfAThingIsReadOrRefused() {
        var many = new StringBuilder("rsal: 1\nrobots:\n");
        for (int i = 0; i < 10_000; i++) {
            many.append("  r%d: {model: pioneer2dx, pose: [%d, 0, 0]}\n".formatted(i, i));
        }
        assertThat(worlds(many.toString()).read().robots()).hasSize(10_000);
        for (String text : List.of(
                "things: {a: {count: 10000, pose: {first: [0, 0, 0], step: [1, 1]}, body: {radius: 1e6}}}",
                "things: {a: {count: 10000, pose: {first: [0, 0, 0], step: [0, 0]}, body: {radius: 4e4}}}",
                "things: {a: {count: 10000, pose: {first: [0, 0, 0], step: [0, 0]}, body: {length: 9e4, width: 9e4}}}",
                "fields: {a: {count: 10000, size: 100, gap: 100, area: [0, 0, 9e4, 9e4]}}\narea: [0, 0, 9e4, 9e4]",
                "fields: {a: {count: 10000, size: 0.01, gap: 0, area: [0, 0, 9, 9]}}\narea: [0, 0, 9, 9]",
                "robots: {a: {count: 10000, model: pioneer2dx}}\narea: [0, 0, 9e2, 9e2]",
                "robots: {a: {count: 10000, model: pioneer2dx}}",
                "walls: [{line: [" + "[0, 0], [1e5, 1], ".repeat(4_000) + "[0, 0]]}]")) {
            readOrRefuse(text.substring(0, 45), worlds("rsal: 1\n" + text));
        }
        String group = "{count: 10000, pose: {first: [0, 0, 0], step: [1, 0]}, body: {radius: 0.1}}";
        var lots = new StringBuilder("rsal: 1\nthings:\n");
        for (int i = 0; i < 1000; i++) {
            lots.append("  a").append(i).append(": ").append(group).append('\n');
        }
        readOrRefuse("lots", worlds(lots.toString()));
    }

    @Test
    void aDamagedImageIsReadOrRefused() {
        byte[] image = "P5 # gray\n4 3\n255\nabcdefghijkl".getBytes(StandardCharsets.ISO_8859_1);
        for (long seed = 0; seed < Rounds.of(62, 1000); seed++) {
            var random = new Random(seed);
            byte[] damaged = Arrays.copyOf(image, random.nextInt(image.length) + 1);
            for (int i = random.nextInt(4); i > 0; i--) {
                damaged[random.nextInt(damaged.length)] = (byte) random.nextInt(256);
            }
            readOrRefuse(
                    "seed " + seed,
                    worlds("rsal: 1\nwalls: [{image: a.pgm, resolution: 1}]").and("a.pgm", damaged));
        }
    }

    private static void readOrRefuse(String which, Worlds worlds) {
        try {
            Scene scene = worlds.read();
            assertThat(scene.things()).as(which).allSatisfy(thing -> {
                assertThat(thing.name()).isNotBlank();
                assertThat(thing.mapFromEntity().isFinite()).isTrue();
            });
        } catch (InvalidSettings e) {
            assertThat(e.problems())
                    .as(which)
                    .isNotEmpty()
                    .hasSizeLessThanOrEqualTo(50)
                    .allSatisfy(problem -> {
                        assertThat(problem.message()).as(which).isNotBlank();
                        assertThat(problem.location().file()).as(which).isNotEmpty();
                    });
        } catch (RuntimeException | StackOverflowError e) {
            throw new AssertionError(which, e);
        }
    }
}
