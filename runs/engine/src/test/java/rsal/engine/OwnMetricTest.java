package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.OptionalDouble;
import java.util.concurrent.ExecutionException;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.engine.report.RunResult;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.Scenario;
import rsal.settings.InvalidSettings;

/// Metrics that people write in Java files beside their scenario.
class OwnMetricTest {
    private static final String SCENARIO = """
            rsal: 1
            scenario: watched
            title: A robot stands, an agent tells it where to look, and metrics look at both
            arguments:
              scale: {type: number, default: 2, description: By what looks count.}
            world: {map: office}
            robots:
              near: {model: pioneer2dx, pose: [0, -1, 0]}
              far: {model: pioneer2dx, pose: [3, -1, 0]}
            agents: {teller: {type: Teller.java}}
            metricTypes:
              - {type: Looks.java, parameters: {scale: $scale, of: near}}
            run:
              clock: {speed: max}
              stop:
                - {when: looks >= 6, outcome: success}
                - {when: time >= 20, outcome: timeout}
            metrics:
              - {name: looks, from: count(looks)}
              - {name: first, from: firstTime(looks > 0)}
              - {name: gap, from: max(gap), per: robot}
              - {name: gapOfFar, from: mean(gap(far))}
              - {name: ticks, from: last(ticks)}
              - {name: allSeen, from: firstTime(allSeen(near))}
            """;
    private static final String LOOK = """
            import rsal.agent.Topic;

            public record Look(String at) {
                public static final Topic<Look> TOPIC = new Topic<>("look", Look.class);
            }
            """;
    private static final String TELLER = """
            import java.time.Duration;
            import rsal.agent.*;

            public class Teller implements Agent {
                public void start(AgentContext self) {
                    self.scheduler().every(Duration.ofSeconds(1), () -> self.publish(Look.TOPIC, new Look("near")));
                }
            }
            """;
    private static final String LOOKS = """
            import java.util.List;
            import rsal.metric.*;
            import rsal.settings.*;

            public class Looks implements MetricType {
                private static final Parameter<Double> SCALE =
                        Parameter.number("scale", 1, 0, 10, "", "By what they count.");
                private static final SignalType GAP = SignalType.ofRobots("gap", "m", "distance to the first robot");
                private static final SignalType TICKS = SignalType.ofRun("ticks", "s", "time of each step");

                public String key() { return "looks"; }
                public String description() { return "Counts looks."; }
                public List<Parameter<?>> parameters() {
                    return List.of(
                            SCALE,
                            Parameter.robots("of", "", List.of(), "Which robots."));
                }
                public List<QuantityType> quantities() {
                    return List.of(
                            QuantityType.of("looks", "", "how many so far"),
                            QuantityType.of("seen", "", "robots that were looked at", NameKind.ROLE).countingAll());
                }
                public List<SignalType> signals() { return List.of(GAP, TICKS); }
                public Metric create(Arguments arguments, RunState run) {
                    return new Metric() {
                        private double looks;

                        public void onMessage(String sender, Object content) {
                            if (content instanceof Look) {
                                looks += arguments.get(SCALE);
                            }
                        }
                        public void onStep() {
                            var first = run.robots().getFirst().mapFromBase().orElseThrow();
                            run.robots().forEach(robot -> run.sample(
                                    GAP, robot.id(), first.distanceTo(robot.mapFromBase().orElseThrow())));
                            run.sample(TICKS, run.time());
                            if (looks > 3) { run.event("looked", "near", "was looked at"); }
                        }
                        public double value(String quantity, List<String> names) {
                            return quantity.equals("looks") ? looks : Math.min(looks, 1);
                        }
                    };
                }
            }
            """;

    @TempDir
    private Path folder;

    @BeforeEach
    void write() throws IOException {
        Files.writeString(folder.resolve("Look.java"), LOOK);
        Files.writeString(folder.resolve("Teller.java"), TELLER);
        Files.writeString(folder.resolve("Looks.java"), LOOKS);
    }

    private RunPlan plan(String text) {
        return Runs.plan(folder, text, RunOptions.NONE);
    }

    private static RunResult run(RunPlan plan) throws Exception {
        try (var run = LiveRun.start(plan)) {
            return run.result().toCompletableFuture().get();
        }
    }

    private static double value(RunResult result, String metric) {
        return result.metrics().getOrDefault(metric, OptionalDouble.empty()).orElseThrow();
    }

    private void refuses(String text, String... words) {
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> plan(text))
                .withMessageContainingAll(words);
    }

    @Test
    void measuresAndConditionsAskForWhatTheyOffer() throws Exception {
        RunResult result = run(plan(SCENARIO));
        assertThat(result.outcome()).isEqualTo("success");
        assertThat(result.metrics())
                .containsEntry("looks", OptionalDouble.of(6))
                .containsEntry("gap.near", OptionalDouble.of(0))
                .containsEntry("gap.far", OptionalDouble.of(3))
                .containsEntry("gapOfFar", OptionalDouble.of(3));
        assertThat(value(result, "ticks")).isBetween(2.9, 3.2);
        assertThat(value(result, "first")).isBetween(0.9, 1.2);
        assertThat(value(result, "allSeen")).isEqualTo(value(result, "first"));
        assertThat(run(plan(SCENARIO)).eventHash()).isEqualTo(result.eventHash());
    }

    @Test
    void whatTheyThrowEndsTheRunByTheirName() throws IOException {
        Files.writeString(
                folder.resolve("Looks.java"),
                LOOKS.replace(
                        "looks += arguments",
                        "if (true) { throw new IllegalStateException(\"Lost count.\"); } looks += arguments"));
        RunPlan plan = plan(SCENARIO);
        assertThatThrownBy(() -> run(plan))
                .isInstanceOf(ExecutionException.class)
                .hasMessageContaining("Metric 'looks' failed: Lost count.");
    }

    @Test
    void theirErrorsAreTheScenarios() throws IOException {
        refuses(SCENARIO.replace("Looks.java", "Loks.java"), "scenario.yaml:12:12: ", "Loks.java");
        refuses(SCENARIO.replace("Looks.java", "loks"), "scenario.yaml:12:12: There is no metric 'loks'.");
        refuses(SCENARIO.replace("scale: $scale", "scal: 3"), "'scal' is not known", "Maybe 'scale'");
        refuses(SCENARIO.replace("of: near", "of: neer"), "'metricTypes.parameters.of'", "neer");
        refuses(SCENARIO.replace("looks >= 6", "loks >= 6"), "'loks' is not a condition or quantity", "Maybe 'looks'");
        refuses(SCENARIO.replace("max(gap)", "max(gab)"), "'gab' is not a signal or quantity", "Maybe 'gap'");
        refuses(
                SCENARIO.replace("metricTypes:\n", "metricTypes:\n  - {type: Looks.java}\n"),
                "Metric 'looks' is named twice.");
        refuses(
                SCENARIO.replace("Looks.java", "Teller.java"),
                "Class 'Teller' is not of the kind 'metric'.",
                "rsal.metric.MetricType");
        Files.writeString(folder.resolve("Looks.java"), LOOKS.replace("\"looks\", \"\"", "\"faults\", \"\""));
        refuses(SCENARIO, "Metric 'looks' offers 'faults', which every run offers already.");
        Files.writeString(folder.resolve("Looks.java"), LOOKS.replace("looks > 3", "loks > 3"));
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> plan(SCENARIO))
                .satisfies(e -> assertThat(e.problems())
                        .singleElement() // what follows from it is not told
                        .satisfies(error -> assertThat(error.toString()).contains("Looks.java:38:21", "loks")));
    }

    /// Of a recording the plan can be looked at, also where conditions ask for what only the metric knows.
    @Test
    void programsFromARecordingAreNotRun() throws Exception {
        Scenario scenario = Scenario.load(
                Files.writeString(folder.resolve("scenario.yaml"), SCENARIO).toString());
        scenario.plan(RunOptions.NONE);
        var files = scenario.readFiles();
        assertThat(files).containsKeys("Looks.java");
        RunPlan plan = Scenario.again(scenario.location().file(), files, false).plan(RunOptions.NONE);
        assertThat(plan.untrusted()).containsExactly("Teller.java", "Looks.java");
        assertThatThrownBy(() -> run(plan)).hasMessageContaining("is a program that came with a recording");
    }
}
