package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.engine.report.RunResult;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.Scenario;
import rsal.settings.InvalidSettings;

/// Controllers that people write in Java files beside their scenario, and what can be set of others.
class OwnControllerTest {
    private static final String SCENARIO = """
            rsal: 1
            scenario: crawling
            title: A robot drives along the corridor with a controller of somebody's own
            world: {map: office}
            robots:
              r:
                model: pioneer2dx
                pose: [0, -1, 0]
                devices:
                  laser: urg04lx
                  localizer: {type: odometry}
                  navigator: {controller: {type: Crawler.java, speed: 0.1}}
            agents:
              driver: {type: Driver.java, robot: r}
            run:
              clock: {speed: max}
              stop:
                - {when: allArrived(r), outcome: success}
                - {when: time >= 60, outcome: timeout}
            metrics:
              - {name: duration, from: count(time)}
              - {name: wallCollisions, from: count(wallCollisions)}
            """;
    private static final String CRAWLER = """
            import java.util.List;
            import rsal.data.Twist2d;
            import rsal.navigation.avoid.*;
            import rsal.navigation.control.*;
            import rsal.settings.*;

            /// Drives straight to the target, slowly.
            public class Crawler implements ControllerType {
                private static final Parameter<Double> SPEED =
                        Parameter.number("speed", 0.2, 0.01, 1, "m/s", "How fast it crawls.");

                public String key() { return "crawler"; }
                public String description() { return "Crawls."; }
                public List<Parameter<?>> parameters() {
                    return List.of(SPEED);
                }
                public Controller create(Arguments arguments, Driven driven) {
                    double speed = Math.min(arguments.get(SPEED), driven.limits().speed());
                    return new Controller() {
                        public Twist2d drive(Obstacles obstacles, Target target, Motion motion) {
                            double bearing = target.bearing();
                            return Twist2d.drive(Math.abs(bearing) < 0.5 ? speed : 0, bearing);
                        }
                        public Twist2d turn(Obstacles obstacles, double angle, Motion motion) {
                            return Twist2d.drive(0, angle);
                        }
                        public Twist2d guarded(Obstacles obstacles, Twist2d wanted, Motion motion) { return wanted; }
                        public void reset() {}
                    };
                }
            }
            """;
    private static final String DRIVER = """
            import rsal.agent.*;
            import rsal.agent.message.NewGoal;
            import rsal.agent.message.GoalReached;
            import rsal.data.Pose2d;
            import rsal.device.Navigator;

            public class Driver implements Agent {
                public void start(AgentContext self) {
                    var goal = new Pose2d(2, -1, 0);
                    self.publish(NewGoal.TOPIC, new NewGoal("r", goal));
                    self.robot().orElseThrow().require(Navigator.class).goTo(goal).result().thenAccept(end -> self.publish(
                            GoalReached.TOPIC, new GoalReached("r", goal, "reached", "")));
                }
            }
            """;

    @TempDir
    private Path folder;

    @BeforeEach
    void write() throws IOException {
        Files.writeString(folder.resolve("Crawler.java"), CRAWLER);
        Files.writeString(folder.resolve("Driver.java"), DRIVER);
    }

    private RunPlan plan(String text) {
        return Runs.plan(folder, text, RunOptions.NONE);
    }

    private static double seconds(RunPlan plan) throws Exception {
        try (var run = LiveRun.start(plan)) {
            RunResult result = run.result().toCompletableFuture().get();
            assertThat(result.outcome()).isEqualTo("success");
            return result.metrics().get("duration").orElseThrow();
        }
    }

    private void refuses(String text, String... words) {
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> plan(text))
                .withMessageContainingAll(words);
    }

    @Test
    void drivesAsItsParametersSay() throws Exception {
        double slow = seconds(plan(SCENARIO));
        double fast = seconds(plan(SCENARIO.replace("speed: 0.1", "speed: 0.3")));
        assertThat(slow).isBetween(15.0, 25.0);
        assertThat(fast).isBetween(4.0, 10.0);
    }

    @Test
    void itsPlanReportsWhatIsSet() {
        assertThat(options(SCENARIO)).containsEntry("controller", Map.of("type", "crawler", "speed", 0.1));
        assertThat(options(SCENARIO.replace("{type: Crawler.java, speed: 0.1}", "dwa")))
                .containsEntry("controller", "dwa");
        assertThat(options(SCENARIO.replace("controller: {type: Crawler.java, speed: 0.1}", "")))
                .containsEntry("controller", "vfh");
    }

    private Map<String, Object> options(String text) {
        return plan(text).robots().getFirst().drivers().getLast().options().written();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "dwa",
                "mpc",
                "nd",
                "snd",
                "vfh",
                "{type: nd, avoidDist: 0.4}",
                "vfh, planner: jumppoint",
                "vfh, goalChecker: stopped"
            })
    void installedOnesAreNamed(String controller) throws Exception {
        assertThat(seconds(plan(SCENARIO.replace("{type: Crawler.java, speed: 0.1}", controller))))
                .isBetween(4.0, 20.0);
    }

    @Test
    void errorsAreReportedWithTheirPlace() throws IOException {
        refuses(
                SCENARIO.replace("speed: 0.1", "sped: 0.1"),
                "scenario.yaml:12:",
                "'sped' is not known",
                "Maybe 'speed'");
        refuses(
                SCENARIO.replace("speed: 0.1", "speed: 7"),
                "'robots.r.devices.navigator.controller.speed'",
                "from 0.01 to 1");
        refuses(SCENARIO.replace("Crawler.java", "Crowler.java"), "scenario.yaml:12:38: ", "Crowler.java");
        refuses(
                SCENARIO.replace("{type: Crawler.java, speed: 0.1}", "vhf"),
                "scenario.yaml:12:31: There is no controller 'vhf'.",
                "Maybe 'vfh'");
        refuses(
                SCENARIO.replace("{type: Crawler.java, speed: 0.1}", "{type: vfh, weightDesiredDir: 1}"),
                "'vfh' can't work with these values.",
                "Raise 'weightDesiredDir'");
        refuses(
                SCENARIO.replace("controller: {type: Crawler.java, speed: 0.1}", "local: nd"),
                "'controller: {type: vfh}'");
        refuses(
                SCENARIO.replace("controller: {type: Crawler.java, speed: 0.1}", "avoidDist: 0.4"),
                "'controller: {type: nd, avoidDist: …}'");
        refuses(SCENARIO.replace("Crawler.java", "Driver.java"), "Class 'Driver' is not of the kind 'controller'.");
        Files.writeString(folder.resolve("Crawler.java"), CRAWLER.replace("driven.limits()", "driven.limit()"));
        refuses(SCENARIO, "Crawler.java:18:", "limit");
    }

    @Test
    void programsFromARecordingAreNotRun() throws Exception {
        Scenario scenario = Scenario.load(
                Files.writeString(folder.resolve("scenario.yaml"), SCENARIO).toString());
        scenario.plan(RunOptions.NONE);
        RunPlan plan = Scenario.again(scenario.location().file(), scenario.readFiles(), false)
                .plan(RunOptions.NONE);
        assertThat(plan.untrusted()).contains("Crawler.java", "Driver.java");
    }
}
