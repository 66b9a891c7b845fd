package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.agent.platform.AgentTurns;
import rsal.data.Pose2d;
import rsal.engine.communication.Traffic;
import rsal.engine.event.EventLog;
import rsal.engine.event.RunClock;
import rsal.engine.metric.MetricsObserver;
import rsal.engine.operator.SentGoals;
import rsal.engine.report.Answer;
import rsal.engine.report.RobotView;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.time.LockstepScheduler;

/// A real robot drives where something simulated stands in its way.
@Timeout(60)
class OverlaidRunTest {
    private static final String SCENARIO = """
            rsal: 1
            scenario: overlaid
            world: {map: office}
            robots:
              real:
                model: pioneer2dx
                pose: [-12, -1, 0]
                mrs: {use: reality}
                proxy: true
                overlay: true
                devices: {laser: urg04lx, localizer: {type: odometry}, navigator: {}, pilot: {}}
            things:
              box: {pose: [-9, -1, 0], body: {radius: 0.25, height: 0.5}}
            """;
    private static final Pose2d START = new Pose2d(-12, -1, 0);
    private static final Pose2d BOX = new Pose2d(-9, -1, 0);
    private static final Pose2d GOAL = new Pose2d(-6, -1, 0);

    @TempDir
    private Path folder;

    private final LockstepScheduler time = new LockstepScheduler(Instant.EPOCH, Runnable::run);
    private Pose2d end = START;

    private RunAssembly stage(String scenario) {
        RunPlan plan = Runs.plan(folder, scenario, RunOptions.NONE);
        var clock = new RunClock(time);
        var eventLog = new EventLog(clock::elapsed, () -> {});
        var observer = new MetricsObserver(plan, eventLog, clock);
        var stage = new RunAssembly(
                plan,
                time,
                clock,
                eventLog,
                observer,
                new Traffic(eventLog, observer, false),
                new AgentTurns(),
                new SentGoals(() -> Duration.ZERO));
        stage.begin();
        time.advance(Duration.ofSeconds(1));
        return stage;
    }

    private static RobotView view(RunAssembly stage) {
        return stage.robotViews().getFirst();
    }

    /// Lets the robot drive.
    ///
    /// @return how near to the middle of the box it came [m]
    private double nearest(RunAssembly stage, int seconds) {
        double nearest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < seconds * 10; i++) {
            time.advance(Duration.ofMillis(100));
            end = START.compose(view(stage).odometry().orElseThrow().value().odomFromBase());
            nearest = Math.min(nearest, end.distanceTo(BOX));
        }
        return nearest;
    }

    /// Of the box, and of the circle around the robot.
    private static double radii(RunAssembly stage) {
        return 0.25 + stage.team().getFirst().spec().model().footprint().circumscribedRadius();
    }

    @ParameterizedTest
    @ValueSource(strings = {"laser: urg04lx", "sonar: front8"})
    void goesAroundItAsIfItWereReal(String sensor) {
        try (RunAssembly stage = stage(SCENARIO.replace("laser: urg04lx", sensor))) {
            assertThat(stage.robotCommands().goTo("real", GOAL, 0)).isEqualTo(new Answer.Sent(1));
            assertThat(nearest(stage, 40)).isBetween(radii(stage), 1.5);
            assertThat(end.distanceTo(GOAL)).isLessThan(0.5);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"laser: urg04lx", "sonar: front8"})
    void behaviorsAvoidItToo(String sensor) {
        try (RunAssembly stage = stage(SCENARIO.replace("laser: urg04lx", sensor))) {
            assertThat(stage.robotCommands().behave("real", "wander", 0)).isEqualTo(new Answer.Done());
            assertThat(nearest(stage, 15)).isBetween(radii(stage), 1.5);
        }
    }

    @Test
    void drivesThroughItWithoutSeeingIt() {
        try (RunAssembly stage = stage(SCENARIO.replace("    overlay: true\n", ""))) {
            stage.robotCommands().goTo("real", GOAL, 0);
            assertThat(nearest(stage, 40)).isLessThan(0.1);
            assertThat(end.distanceTo(GOAL)).isLessThan(0.5);
        }
    }
}
