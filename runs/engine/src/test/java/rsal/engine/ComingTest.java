package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rsal.agent.platform.AgentPlatform;
import rsal.data.Pose2d;
import rsal.device.SimulationControl.Standing;
import rsal.engine.report.Answer;
import rsal.engine.report.DeviceView;
import rsal.engine.report.PlacedThing;
import rsal.engine.report.Reading;
import rsal.engine.report.RobotView;
import rsal.engine.report.RunEvent;
import rsal.engine.report.RunResult;
import rsal.engine.report.Snapshot;
import rsal.model.RobotModels;
import rsal.robot.Robot;
import rsal.robot.RobotModel;
import rsal.scenario.RunOptions;
import rsal.system.Bridge;
import rsal.system.BridgeContext;
import rsal.system.BridgeProvider;
import rsal.system.ExportedDevice;
import rsal.time.Scheduler;

/// Robots and things come and go while a run goes on.
@Timeout(60)
class ComingTest {
    private static final Pose2d THERE = new Pose2d(-8, -1, 0);
    private static final Answer.Done DONE = new Answer.Done();

    @TempDir
    private Path folder;

    private LiveRun run;

    @BeforeEach
    void start() throws InterruptedException {
        run = LiveRun.start(Runs.plan(folder, Runs.TWO_WANDERERS, RunOptions.NONE.withSpeed(2)));
        await(snapshot -> snapshot.agents().size() == 2);
    }

    @AfterEach
    void stop() {
        run.close();
    }

    private Snapshot await(Predicate<Snapshot> wanted) throws InterruptedException {
        while (true) {
            var news = new CountDownLatch(1);
            try (var _ = run.onSnapshot(news::countDown)) {
                Snapshot snapshot = run.snapshot();
                if (wanted.test(snapshot)) {
                    return snapshot;
                }
                news.await();
            }
        }
    }

    private static Answer answer(CompletionStage<Answer> stage) {
        return stage.toCompletableFuture().orTimeout(10, TimeUnit.SECONDS).join();
    }

    private static boolean has(Snapshot snapshot, String robot) {
        return snapshot.robots().stream().anyMatch(view -> view.id().equals(robot));
    }

    @Test
    void anAddedRobotHasWhatThoseLikeItHave() throws InterruptedException {
        assertThat(answer(run.operator().addRobot("prey", THERE))).isEqualTo(new Answer.Added("prey-1"));
        Snapshot snapshot = await(now -> now.robots().stream()
                .anyMatch(robot -> robot.id().equals("prey-1")
                        && robot.scan().isPresent()
                        && robot.estimate().isPresent()
                        && robot.truth().orElseThrow().distanceTo(THERE) > 0.05));
        RobotView robot = snapshot.robots().getLast();
        assertThat(robot.role()).isEqualTo("prey");
        assertThat(robot.color()).isEqualTo(snapshot.robots().getFirst().color());
        assertThat(robot.devices()).extracting(DeviceView::name).contains("laser", "localizer");
        assertThat(snapshot.team()).extracting(mate -> mate.spec().id()).containsExactly("prey", "hunter-1", "prey-1");
        assertThat(snapshot.team().getLast().body()).isPresent();
        assertThat(snapshot.agents().getLast().view().agent())
                .satisfies(agent -> assertThat(List.of(agent.name(), agent.role(), agent.type(), agent.robot()))
                        .containsExactly("run-prey-1", "run", "quitter", "prey-1"));
        assertThat(run.events(0))
                .anySatisfy(event -> assertThat(event.kind() + event.subject() + event.text())
                        .isEqualTo("operatorprey-1added at (-8.00, -1.00, 0°)"))
                .filteredOn(event -> event.subject().equals("prey-1"))
                .as("told once")
                .hasSize(1);
        assertThat(answer(run.operator().addRobot("hunter-1", new Pose2d(-4, -1, 0))))
                .isEqualTo(new Answer.Added("hunter-2"));
    }

    @Test
    void aRemovedRobotLeavesWithItsAgentAndTheOthersGoOn() throws InterruptedException {
        assertThat(answer(run.operator().remove("prey"))).isEqualTo(DONE);
        Snapshot snapshot = await(now -> !has(now, "prey"));
        assertThat(snapshot.team()).hasSize(2);
        assertThat(snapshot.agents())
                .extracting(agent -> agent.view().status())
                .containsExactly(AgentPlatform.Status.ENDED, AgentPlatform.Status.RUNNING);
        assertThat(run.events(0))
                .filteredOn(event -> event.subject().startsWith("prey"))
                .extracting(RunEvent::kind)
                .containsExactly("operator");
        Pose2d before = snapshot.robots().getFirst().truth().orElseThrow();
        await(now -> now.robots().getFirst().truth().orElseThrow().distanceTo(before) > 0.05);
        assertThat(answer(run.operator().remove("prey"))).isInstanceOf(Answer.Refused.class);
        assertThat(answer(run.operator().addRobot("prey", THERE))).isEqualTo(new Answer.Added("prey-1"));
    }

    @Test
    void anAddedRobotStandsAsLongAsTheEmergencyStopHolds() throws InterruptedException {
        answer(run.operator().estop());
        answer(run.operator().addRobot("prey", THERE));
        Snapshot first = await(now -> has(now, "prey-1"));
        Snapshot later = await(now -> now.time().minus(first.time()).toMillis() > 1000);
        assertThat(later.robots().getLast().truth()).contains(THERE);
        answer(run.operator().rearm());
        await(now -> now.robots().getLast().truth().orElseThrow().distanceTo(THERE) > 0.05);
    }

    private List<String> readings(String robot) {
        return ((Answer.Read) answer(run.inspector().readings(robot)))
                .readings().stream().map(Reading::device).toList();
    }

    @Test
    void aRobotsReadingsAreOfWhereItIs() throws InterruptedException {
        await(now -> now.robots().getFirst().scan().isPresent());
        assertThat(readings("prey")).contains("laser");
        run.pause();
        await(Snapshot::paused);
        assertThat(answer(run.operator().place("prey", THERE))).isEqualTo(DONE);
        assertThat(readings("prey")).doesNotContain("laser");
        assertThat(answer(run.inspector().readings("nobody"))).isInstanceOf(Answer.Refused.class);
    }

    @Test
    void aRobotCanBeGivenItsPoseWithoutBeingMoved() throws InterruptedException {
        Snapshot before = await(now -> now.robots().getFirst().estimate().isPresent());
        Pose2d truth = before.robots().getFirst().truth().orElseThrow();
        assertThat(truth.distanceTo(THERE)).isGreaterThan(3);
        assertThat(answer(run.operator().believe("prey", THERE))).isEqualTo(DONE);
        Snapshot reported = await(now -> now.robots()
                        .getFirst()
                        .estimate()
                        .orElseThrow()
                        .value()
                        .mapFromBase()
                        .distanceTo(THERE)
                < 1);
        assertThat(reported.robots().getFirst().truth().orElseThrow().distanceTo(truth))
                .isLessThan(2);
        assertThat(run.events(0)).extracting(RunEvent::text).contains("told that it is at (-8.00, -1.00, 0°)");
    }

    @Test
    void thingsAreAddedMovedAndRemoved() throws InterruptedException {
        assertThat(answer(run.operator().add(PlacedThing.BOX, THERE))).isEqualTo(new Answer.Added("box-1"));
        assertThat(answer(run.operator().add(PlacedThing.BALL, new Pose2d(-7, -1, 0))))
                .isEqualTo(new Answer.Added("ball-1"));
        Snapshot snapshot = await(now -> now.things().size() == 2);
        assertThat(snapshot.things()).extracting(Standing::name).containsExactly("box-1", "ball-1");
        var next = new Pose2d(-10, -1, 1);
        assertThat(answer(run.operator().place("box-1", next))).isEqualTo(DONE);
        await(now -> now.things().getFirst().mapFromThing().equals(next));
        assertThat(answer(run.operator().remove("box-1"))).isEqualTo(DONE);
        await(now -> now.things().size() == 1);
        assertThat(run.events(0))
                .filteredOn(event -> event.subject().equals("box-1"))
                .extracting(RunEvent::text)
                .containsExactly("added at (-8.00, -1.00, 0°)", "placed at (-10.00, -1.00, 57°)", "removed");
    }

    @Test
    void aRobotOfAModelComesAndDoesWhatPeopleAskOfIt() throws InterruptedException {
        assertThat(RobotModels.readBuiltIn())
                .extracting(RobotModel::name)
                .containsExactlyElementsOf(RobotModels.builtIn());
        assertThat(answer(run.operator().newRobot("pioneer3at", THERE))).isEqualTo(new Answer.Added("pioneer3at-1"));
        Snapshot snapshot = await(now -> has(now, "pioneer3at-1"));
        assertThat(snapshot.agents()).hasSize(2);
        assertThat(snapshot.robots().getLast().truth()).isPresent();
        assertThat(answer(run.operator().behave("pioneer3at-1", "wander"))).isEqualTo(DONE);
        await(now -> now.robots().getLast().truth().orElseThrow().distanceTo(THERE) > 0.3);
        assertThat(answer(run.operator().goTo("pioneer3at-1", THERE))).isEqualTo(new Answer.Sent(1));
        assertThat(answer(run.operator().addRobot("pioneer3at-1", new Pose2d(-4, -1, 0))))
                .isEqualTo(new Answer.Added("pioneer3at-2"));
        assertThat(run.events(0))
                .filteredOn(event -> event.subject().equals("pioneer3at-1"))
                .extracting(RunEvent::text)
                .startsWith("added at (-8.00, -1.00, 0°)")
                .doesNotContain("is there");
        refuses(run.operator().newRobot("pioneer3at", new Pose2d(-4, -1, 0)), "'pioneer3at-2' is in the way");
        refuses(run.operator().newRobot("pioneer", THERE), "There is no robot model 'pioneer'.");
    }

    /// Its agent has a navigator, but wants nothing of people's orders.
    @Test
    void aRobotWhoseAgentTakesNoOrdersGoesBesideIt() throws InterruptedException {
        run.close();
        String navigating = Runs.TWO_WANDERERS
                .replace("error: 0.2}}", "error: 0}, navigator: {}}")
                .replace(
                        "{type: quitter, robot: prey, parameters: {caughtAfter: $caughtAfter, by: hunter-1, distance: 30}}",
                        "{type: chatter, robot: prey}")
                .replace("time >= 20", "time >= 90");
        run = LiveRun.start(Runs.plan(folder, navigating, RunOptions.NONE.withSpeed(60)));
        await(now -> now.agents().size() == 2);
        assertThat(answer(run.operator().goTo("prey", THERE))).isEqualTo(new Answer.Sent(1));
        Runs.result(run);
        assertThat(run.events(0))
                .filteredOn(event -> event.subject().equals("prey"))
                .extracting(RunEvent::text)
                .contains("sent to (-8.00, -1.00, 0°)", "is at (-8.00, -1.00, 0°)");
    }

    @Test
    void saysWhyNot() {
        refuses(run.operator().add(PlacedThing.BOX, new Pose2d(-1000, 0, 0)), "outside");
        refuses(run.operator().add(PlacedThing.BOX, new Pose2d(-31.4, -7.7, 0)), "'wall' is in the way");
        refuses(
                run.operator().addRobot("nobody", THERE),
                "There is no 'nobody'; there are the robots [prey, hunter-1]");
        refuses(run.operator().addRobot("prey", new Pose2d(-31.4, -7.7, 0)), "'wall' is in the way");
        refuses(run.operator().remove("nobody"), "There is no 'nobody'");
        refuses(run.operator().place("nobody", THERE), "There is no 'nobody'");
        refuses(run.operator().believe("nobody", THERE), "There is no 'nobody'");
        refuses(run.operator().believe("prey", new Pose2d(-1000, 0, 0)), "outside");
        answer(run.operator().add(PlacedThing.BOX, THERE));
        refuses(run.operator().place("box-1", new Pose2d(-31.4, -7.7, 0)), "'wall' is in the way");
        refuses(run.operator().add(PlacedThing.BALL, THERE), "'box-1' is in the way");
        refuses(run.operator().addRobot("prey", THERE), "'box-1' is in the way");
    }

    private static void refuses(CompletionStage<Answer> order, String why) {
        assertThat(answer(order))
                .isInstanceOfSatisfying(
                        Answer.Refused.class,
                        refused -> assertThat(refused.why()).contains(why));
    }

    @Test
    void itIsTheSameRunOnOneCoreAndOnTwo() {
        String text = Runs.TWO_WANDERERS.replace("agents:\n", "agents:\n  boss: {type: recruiter}\n");
        String[] hashes = new String[3];
        for (int i = 0; i < hashes.length; i++) {
            try (var once = LiveRun.of(Runs.plan(folder, text, RunOptions.NONE))
                    .helpers(i == 0 ? 1 : 2)
                    .start()) {
                RunResult result = Runs.result(once);
                assertThat(result.outcome()).isEqualTo("timeout");
                hashes[i] = result.eventHash();
                assertThat(once.events(0))
                        .filteredOn(event -> event.text().equals("was removed"))
                        .extracting(RunEvent::subject)
                        .contains("hunter-1", "extra-0", "extra-9");
                assertThat(once.events(0)).extracting(RunEvent::kind).doesNotContain("fault", "health");
                assertThat(once.snapshot().robots()).extracting(RobotView::id).contains("prey", "extra-17");
            }
        }
        assertThat(hashes[1]).isEqualTo(hashes[0]);
        assertThat(hashes[2]).isEqualTo(hashes[0]);
    }

    /// Notes who comes and goes.
    private static final class Notes implements BridgeProvider, Bridge {
        private final List<String> notes = new CopyOnWriteArrayList<>();

        @Override
        public String key() {
            return "notes";
        }

        @Override
        public String description() {
            return "Notes who comes and goes.";
        }

        @Override
        public int defaultPort() {
            return 7000;
        }

        @Override
        public Bridge open(InetSocketAddress at, BridgeContext context, Scheduler scheduler) {
            context.robots().forEach(robot -> notes.add("has " + robot.id()));
            return this;
        }

        @Override
        public List<ExportedDevice> offers() {
            return List.of();
        }

        @Override
        public List<ExportedDevice> join(Robot robot) throws IOException {
            notes.add("gets %s with %d devices"
                    .formatted(robot.id(), robot.devices().size()));
            if (robot.id().equals("prey-2")) {
                throw new IOException("There is no port left.");
            }
            return List.of(new ExportedDevice(7002, "base", robot.id()), new ExportedDevice(7002, "laser", robot.id()));
        }

        @Override
        public void leave(String robot) {
            notes.add("loses " + robot);
        }

        @Override
        public void close() {}
    }

    @Test
    void robotsThatComeAndGoAreOfferedAndTakenBack() throws InterruptedException {
        var notes = new Notes();
        assertThat(answer(run.operator().bridge(notes, new InetSocketAddress(InetAddress.getLoopbackAddress(), 0))))
                .isInstanceOf(Answer.Bridged.class);
        assertThat(answer(run.operator().addRobot("prey", THERE))).isEqualTo(new Answer.Added("prey-1"));
        await(now -> has(now, "prey-1"));
        assertThat(answer(run.operator().remove("prey-1"))).isEqualTo(DONE);
        await(now -> !has(now, "prey-1"));
        assertThat(answer(run.operator().addRobot("prey", THERE))).isEqualTo(new Answer.Added("prey-2"));
        await(now -> has(now, "prey-2"));
        assertThat(notes.notes)
                .containsExactly(
                        "has prey",
                        "has hunter-1",
                        "gets prey-1 with 4 devices",
                        "loses prey-1",
                        "gets prey-2 with 4 devices");
        assertThat(run.events(0))
                .filteredOn(event -> event.kind().equals("bridge"))
                .extracting(event -> event.subject() + " " + event.text())
                .containsExactly("prey-1 is offered at port 7002", "prey-2 is not offered: There is no port left.");
    }
}
