package rsal.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import com.networknt.schema.InputFormat;
import com.networknt.schema.Schema;
import com.networknt.schema.SchemaRegistry;
import com.networknt.schema.SpecificationVersion;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Value;
import rsal.world.yaml.YamlFormat;
import rsal.yaml.Yaml;
import tools.jackson.databind.json.JsonMapper;

/// The schema for worlds says what their reader says, as far as a schema can.
class WorldSchemaTest {
    private static final Path DOCS = Path.of("../../docs");
    private static final String DRIVE = """
            drive: {maxSpeed: [-0.5, 1], maxTurnRate: 90, maxAcceleration: 1, maxTurnAcceleration: 90, \
            odometryNoise: {distancePerMeter: 0, headingPerMeter: 0, headingPerDegree: 0}}""";

    private final Schema schema = SchemaRegistry.withDefaultDialect(SpecificationVersion.DRAFT_2020_12)
            .getSchema(Files.readString(DOCS.resolve("reference/world.schema.json")), InputFormat.JSON);

    WorldSchemaTest() throws IOException {}

    private boolean schemaAccepts(String text) {
        return schema.validate(new JsonMapper().writeValueAsString(plain(Yaml.read("a", text))), InputFormat.JSON)
                .isEmpty();
    }

    private static boolean readerAccepts(String text) {
        try {
            new YamlFormat()
                    .read(
                            "a.world.yaml",
                            (path, _, askedAt) -> {
                                if (path.equals("a.world.yaml")) {
                                    return text.getBytes(StandardCharsets.UTF_8);
                                }
                                if (path.equals("a.pgm")) {
                                    return "P2 2 1 255 0 255".getBytes(StandardCharsets.UTF_8);
                                }
                                throw new InvalidSettings(askedAt, "There is no file '%s'.".formatted(path), "");
                            },
                            1);
            return true;
        } catch (InvalidSettings _) {
            return false;
        }
    }

    @Test
    void theExampleFollowsIt() throws IOException {
        assertThat(schemaAccepts(Files.readString(DOCS.resolve("examples/yard.world.yaml"))))
                .isTrue();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "title: a\ndescription: b\nstep: 0.05\nend: 3\nonCollision: slide\narea: [0, 0, 1, 1]",
                "walls: [{line: [[0, 0], [1, 0]], thickness: 0, bottom: -1, height: 2, color: '#ff0000', obstacle: false}]",
                "walls: [{radius: 1, center: [1, 2]}, {outline: [[0, 0], [1, 0], [0, 1]], pose: [1, 2, 3], thickness: 0.1}]",
                "walls: [{image: a.pgm, resolution: [0.1, 0.2], origin: [1, 2, 0], fenced: true}, {image: a.pgm, size: [1, 2]}]",
                "walls: [{map: office}]",
                "things: {a: {pose: [1, 2, 3, 4], body: {radius: 1, fiducial: 3}, moves: true, reflectance: -1}}",
                "things: {a: {pose: [[1, 2, 3], [5, 2, 3, 4]], body: {pieces: [{radius: 1}, {length: 1, width: 2}], key: 2}}}",
                "things: {a: {count: 2, pose: {first: [1, 2, 3], step: [1, 1]}, body: {radius: 1}}}",
                "fields: {a: {count: 2, size: 1, height: [1, 2], shapes: [disc], seed: -1, blob: false}}",
                "robots: {a: {model: pioneer2dx, role: b, devices: {laser: urg04lx}, odometry: start, program: wander}}",
                "robots: {a: {model: pioneer2dx, count: 2, pose: {free: true, clearance: 0.3}}}\narea: [0, 0, 9, 9]",
                "models: {m: {body: {pieces: []}, " + DRIVE + "}}",
                "models: {m: {title: M, body: {pieces: [{radius: 1, obstacle: false}]}, mounts: {l: [0, 0, 0, 1]}, sensors: {l: p}, "
                        + DRIVE
                        + "}}\nparts: {p: {type: laser, fieldOfView: 9, samples: 9, range: [0, 1], noise: 0, period: 1}}",
                "things: {a: {body: {radius: 1}, givingPower: 50}}",
                "parts: {p: {type: laser, fieldOfView: 9, samples: 9, range: [0, 1], noise: 0, relativeNoise: 0.1, angularNoise: 1, period: 1}}",
                "parts: {p: {type: sonars, sensors: [[0, 0, 0]], fieldOfView: 9, range: [0, 1], noise: 0, relativeNoise: 1, period: 1}}",
                "parts: {p: {type: fiducial-finder, fieldOfView: 9, range: 1, idRange: 1, allHeights: true, period: 1}}",
                "parts: {p: {type: gripper, length: 1, width: 1, height: 1, paddleLength: 0.5, paddleWidth: 0.1, closingTime: 1,"
                        + " liftingTime: 1, closed: true, raised: true, snatches: false, period: 1}}",
            })
    void whatTheReaderAcceptsItAccepts(String text) {
        assertThat(readerAccepts("rsal: 1\n" + text)).isTrue();
        assertThat(schemaAccepts("rsal: 1\n" + text)).isTrue();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "wals: []",
                "step: 1",
                "onCollision: slip",
                "area: [0, 0, 1]",
                "walls: {}",
                "walls: [{}]",
                "walls: [{line: [[0, 0]]}]",
                "walls: [{line: [[0, 0], [1, 0]], radius: 1, image: a.pgm}]",
                "walls: [{image: a.pgm}]",
                "walls: [{image: a.pgm, resolution: 1, size: [1, 1]}]",
                "walls: [{length: 1}]",
                "walls: [{radius: 1, heigth: 2}]",
                "things: {a: {}}",
                "things: {a: {body: {radius: 1}, color: '#12'}}",
                "things: {a: {body: {radius: 1}, blob: 1}}",
                "things: {a: {body: {radius: 1}, pose: [1, 2]}}",
                "things: {a: {body: {radius: 1}, count: 0}}",
                "things: {a: {body: {radius: 1}, givingPower: -1}}",
                "fields: {a: {}}",
                "fields: {a: {count: 1, density: 1}}",
                "fields: {a: {count: 1, shapes: [ball]}}",
                "fields: {a: {count: 1, size: 0}}",
                "robots: {a: {}}",
                "robots: {a: {model: pioneer2dx, odometry: end}}",
                "robots: {a: {model: pioneer2dx, pose: {free: false}}}",
                "models: {m: {body: {radius: 1}}}",
                "models: {m: {body: {radius: 1}, drvie: 1, " + DRIVE + "}}",
            })
    void whatItRefusesTheReaderRefuses(String text) {
        assertThat(schemaAccepts("rsal: 1\n" + text)).isFalse();
        assertThat(readerAccepts("rsal: 1\n" + text)).isFalse();
    }

    private static Object plain(Value value) {
        return switch (value) {
            case Value.Scalar scalar -> scalar.value();
            case Value.Sequence sequence ->
                sequence.items().stream().map(WorldSchemaTest::plain).toList();
            case Value.Mapping mapping -> {
                var plain = new LinkedHashMap<String, Object>();
                mapping.entries().forEach((key, inner) -> plain.put(key, plain(inner)));
                yield plain;
            }
        };
    }
}
