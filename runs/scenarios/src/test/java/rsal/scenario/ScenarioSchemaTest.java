package rsal.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import com.networknt.schema.Error;
import com.networknt.schema.InputFormat;
import com.networknt.schema.Schema;
import com.networknt.schema.SchemaRegistry;
import com.networknt.schema.SpecificationVersion;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rsal.scenario.installed.Catalog;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Value;
import rsal.yaml.Yaml;
import tools.jackson.databind.json.JsonMapper;

class ScenarioSchemaTest {
    private static final Path COMMITTED = Path.of("../../docs/reference/scenario.schema.json");

    private static final Schema SCHEMA = SchemaRegistry.withDefaultDialect(SpecificationVersion.DRAFT_2020_12)
            .getSchema(ScenarioSchema.json(), InputFormat.JSON);

    /// What a user has: without the agents, devices and hosts of the tests.
    private static Catalog shipped() {
        Catalog all = Catalog.installed();
        return new Catalog(
                shipped(all.systems()),
                shipped(all.hosts()),
                shipped(all.drivers()),
                shipped(all.agents()),
                all.languages(),
                shipped(all.metrics()),
                all.plugins(),
                all.formats(),
                all.models(),
                all.parts(),
                all.maps());
    }

    private static <P> Map<String, P> shipped(Map<String, P> providers) {
        Predicate<P> ofTests = provider -> provider.getClass().getName().matches("(own|rsal\\.testkit)\\..*");
        var shipped = new TreeMap<>(providers);
        shipped.values().removeIf(ofTests);
        return shipped;
    }

    @Test
    void theCommittedSchemaIsCurrent() throws IOException {
        String current = new ScenarioSchema(shipped()).write();
        Path written =
                Files.writeString(Files.createDirectories(Path.of("target")).resolve("scenario.schema.json"), current);
        assertThat(Files.readString(COMMITTED).equals(current))
                .as("What can be named in scenarios has changed. Copy %s to %s.", written, COMMITTED)
                .isTrue();
    }

    @Test
    void theBuiltInScenariosFollowIt() {
        assertThat(Scenario.builtIn())
                .isNotEmpty()
                .allSatisfy(scenario -> assertThat(errors(scenario.settings())).isEmpty());
    }

    /// What messages say of errors that can't be seen without knowing other parts of the scenario.
    private static final List<String> BEYOND_A_SCHEMA = List.of(
            "lies outside",
            "There is no file",
            "There is no part",
            "needs a LaserScanner",
            "needs a RangeSensor",
            "needs a Navigator",
            "needs a localizer of type",
            "Robot 'prey'",
            "has 1 for 2 robots",
            "no free place",
            "least x, least y",
            "There is no argument",
            "never inside other text",
            "No robots have the role",
            "needs a robot with",
            "must be a role of robots",
            "can't follow simulated time",
            "character",
            "is not a signal",
            "no value per robot",
            "from 1 to 4", // an argument's value against its declaration
            "'hunter' is not known",
            "can't be the role",
            "can't be the name of an agent",
            "There are two agents",
            "'hunters' must be",
            "the id of one, a pattern",
            "a pattern (r*)",
            "have no sensor",
            "not 'hunter-3'",
            "can't be biased like this",
            "needs an error",
            "[least, most]",
            "must be at most 'range'",
            "must be an agent",
            "can't work with these options", // one against others
            "can't work with these values");

    static List<List<String>> wrong() {
        return ScenarioTest.wrong().stream()
                .filter(example -> example.subList(2, example.size()).stream()
                        .noneMatch(words -> BEYOND_A_SCHEMA.stream().anyMatch(words::contains)))
                .toList();
    }

    @ParameterizedTest
    @MethodSource("wrong")
    void refusesWhatTheReaderRefuses(List<String> example) {
        String text = ScenarioTest.GOOD.replace(example.get(0), example.get(1));
        assertThat(errors(Yaml.read("wrong.yaml", text))).isNotEmpty();
    }

    static List<List<String>> right() {
        return List.of(
                List.of("mas: {use", "communication: {}\nmas: {use"),
                List.of("mas: {use", "communication: {range: 15, behindWalls: 5, loss: 0.05}\nmas: {use"),
                List.of("mas: {use", "communication: {delay: [0.02, 0.1], bandwidth: 50}\nmas: {use"),
                List.of("rsal: 1", "rsal: 1"),
                List.of("speed: 2}", "speed: max}"),
                List.of("count: $hunters", "count: 2"),
                List.of("count: $hunters", "mrs: {use: reality, host: $way}\n    count: 2"),
                List.of("count: $hunters", "members: [{name: ann, mrs: {use: reality}, pose: auto}, {fiducial: 7}]"),
                List.of("[$start, -1.0, 180]", "auto"),
                List.of("[$start, -1.0, 180]", "[[$start, -1.0, 180]]"),
                List.of("{free: true, clearance: 0.5}", "[[-5, -1, 0], [-3, -1, 0], [-1, -1, 0]]"),
                List.of("clearance: 0.5", "within: [-10, -2, 10, 2]"),
                List.of("urg04lx", "utm30lx"),
                List.of("localizer: {type: truthful, error: 0.1}", "localizer: truthful"),
                List.of("localizer: {type: truthful, error: 0.1}", "truthful: {error: 0.2}"),
                List.of("speed: 0.2", "speed: 0"),
                List.of("mas: {use: plain}\nmrs: {use: sim, step: 0.05}\n", ""),
                List.of("mrs: {use: sim, step: 0.05}", "mrs: {step: 0.05}"),
                List.of(", outcome: success, after: 2", ", outcome: failure"),
                List.of("per: robot, unit: m, better: less, bound: {max: 0.3}", "bound: {min: 0}"),
                List.of("    arguments: {hunters: 3}\n", "    metrics: []\n"),
                List.of("parameters: {speed: 0.2}", "parameters: {}"),
                rightFault("kind: dead, robots: all, devices: all, at: 30, for: 20"),
                rightFault(
                        "kind: frozen, robots: [prey, hunter-1], devices: [laser, SonarArray], every: 60, for: [1, 5]"),
                rightFault("kind: biased, robots: \"h*\", devices: RangeSensor, range: -0.1"),
                rightFault("kind: noisy, robots: prey, devices: [localizer, base], range: 0.1, angle: 2"),
                rightFault("kind: motorDead, robots: any, power: 0.5"),
                rightFault("kind: slip, robots: hunter, pick: $hunters, way: 0.5, drift: 3"),
                rightFault("kind: gone, robots: prey, stays: true"),
                rightFault("kind: lost, topics: [pose, \"h*\"], from: operator, to: [chase, prey], share: 0.1"),
                rightFault("kind: late"),
                rightFault("kind: doubled, delay: [0, 2], at: 3, every: 30, for: 5"));
    }

    private static List<String> rightFault(String fault) {
        return List.of("run:\n  seed", "faults: [{%s}]\nrun:\n  seed".formatted(fault));
    }

    @ParameterizedTest
    @MethodSource("right")
    void acceptsWhatTheReaderAccepts(List<String> example) {
        assertThat(ScenarioTest.GOOD).contains(example.get(0));
        String text = ScenarioTest.GOOD.replace(example.get(0), example.get(1));
        assertThat(errors(Yaml.read("right.yaml", text))).isEmpty();
        Scenario.read("right.yaml", text, FileSource.folder(Path.of("."))).check();
    }

    @Test
    void readerAndSchemaAgreeThatNothingIsTooLittle() {
        assertThat(errors(Yaml.read("empty.yaml", "rsal: 1"))).isNotEmpty();
        org.assertj.core.api.Assertions.assertThatThrownBy(
                        () -> Scenario.read("empty.yaml", "rsal: 1", FileSource.folder(Path.of("."))))
                .isInstanceOf(InvalidSettings.class)
                .hasMessageContainingAll("'scenario'", "'world.map'", "no robots");
    }

    private static List<Error> errors(Value.Mapping settings) {
        return SCHEMA.validate(new JsonMapper().writeValueAsString(plain(settings)), InputFormat.JSON);
    }

    private static Object plain(Value value) {
        return switch (value) {
            case Value.Scalar scalar -> scalar.value();
            case Value.Sequence sequence ->
                sequence.items().stream().map(ScenarioSchemaTest::plain).toList();
            case Value.Mapping mapping -> {
                var plain = new LinkedHashMap<String, Object>();
                mapping.entries().forEach((key, inner) -> plain.put(key, plain(inner)));
                yield plain;
            }
        };
    }
}
