package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import java.util.function.Predicate;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rsal.data.Pose2d;
import rsal.device.GoalHandle;
import rsal.device.SimulationControl;
import rsal.device.SimulationControl.Placement;
import rsal.engine.report.RunEvent;
import rsal.scenario.RunOptions;
import rsal.system.Bridge;
import rsal.system.BridgeContext;
import rsal.system.BridgeProvider;
import rsal.system.RunControl;
import rsal.system.RunControl.Spawnable;
import rsal.time.Scheduler;

/// What a program behind a bridge can do to a run.
@Timeout(60)
class BridgeControlTest {
    private static final Pose2d THERE = new Pose2d(-8, -1, 0);
    private static final Placement PLACED = new Placement.Placed();

    @TempDir
    private Path folder;

    private final CompletableFuture<BridgeContext> opened = new CompletableFuture<>();
    private LiveRun run;
    private RunControl control;
    private SimulationControl world;

    /// Keeps what it may offer.
    private final class Kept extends IdleBridge implements BridgeProvider {
        @Override
        public String key() {
            return "kept";
        }

        @Override
        public String description() {
            return "Keeps what it may offer.";
        }

        @Override
        public int defaultPort() {
            return 7000;
        }

        @Override
        public Bridge open(InetSocketAddress at, BridgeContext context, Scheduler scheduler) {
            opened.complete(context);
            return this;
        }
    }

    @BeforeEach
    void start() {
        run = LiveRun.start(Runs.plan(folder, Runs.TWO_WANDERERS, RunOptions.NONE.withSpeed(2)));
        run.operator().bridge(new Kept(), new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
        BridgeContext context = await(opened);
        control = context.control().orElseThrow();
        world = context.simulation().orElseThrow();
    }

    @AfterEach
    void stop() {
        run.close();
    }

    private static <T> T await(CompletableFuture<T> answer) {
        return answer.orTimeout(20, TimeUnit.SECONDS).join();
    }

    /// Asks on the run's thread.
    private <T> T ask(Function<RunControl, T> question) {
        var answer = new CompletableFuture<T>();
        control.execute(() -> {
            try {
                answer.complete(question.apply(control));
            } catch (IllegalStateException e) {
                answer.completeExceptionally(e);
            }
        });
        return await(answer);
    }

    private boolean is(Predicate<RunControl> question) {
        return ask(question::test);
    }

    private Placement order(Function<RunControl, Placement> order) {
        return ask(order);
    }

    private <E> List<E> all(Function<RunControl, List<E>> question) {
        return ask(question);
    }

    private Pose2d truth(String entity) {
        return ask(_ -> world.truth(entity).orElseThrow());
    }

    private Duration elapsed() {
        return await(run.freshSnapshot().toCompletableFuture()).time();
    }

    private boolean pause() {
        return ask(paused -> {
            paused.pause();
            return paused.isPaused();
        });
    }

    @Test
    void aPausedRunStandsStillAndAnswers() {
        assertThat(is(RunControl::isPausable)).isTrue();
        assertThat(is(RunControl::isPaused)).isFalse();
        assertThat(pause()).isTrue();
        Duration then = elapsed();
        assertThat(is(RunControl::isPaused)).isTrue();
        assertThat(elapsed()).isEqualTo(then);
        assertThat(is(paused -> {
                    paused.resume();
                    return paused.isPaused();
                }))
                .isFalse();
        await(run.when(now -> now.time().compareTo(then) > 0).toCompletableFuture());
    }

    @Test
    void stepsAreMadeAndCounted() {
        pause();
        Duration then = elapsed();
        var reported = new ArrayList<Long>();
        var ended = new CompletableFuture<Long>();
        ask(paused -> {
            GoalHandle<Long, Long> steps = paused.step(5);
            steps.onFeedback(made -> reported.add(made.value()));
            return steps.result().thenAccept(ended::complete);
        });
        assertThat(await(ended)).isEqualTo(5);
        assertThat(reported).containsExactly(1L, 2L, 3L, 4L, 5L);
        assertThat(elapsed().minus(then)).isEqualTo(run.plan().step().multipliedBy(5));
        assertThat(is(RunControl::isPaused)).isTrue();
    }

    @Test
    void stepsEndWhenTheyAreCanceledOrTheRunIsResumed() {
        pause();
        for (boolean resuming : List.of(true, false)) {
            var ended = new CompletableFuture<Long>();
            GoalHandle<Long, Long> steps = ask(paused -> paused.step(1_000_000));
            steps.result().thenAccept(ended::complete);
            assertThatThrownBy(() -> ask(paused -> paused.step(1))).hasMessageContaining("can't be stepped now");
            assertThat(is(paused -> {
                        if (resuming) {
                            paused.resume();
                        } else {
                            steps.cancel();
                        }
                        return ended.isDone();
                    }))
                    .isTrue();
            assertThat(await(ended)).isBetween(0L, 999_999L);
            pause();
        }
        ask(paused -> {
            paused.resume();
            return true;
        });
        assertThatThrownBy(() -> ask(running -> running.step(1))).hasMessageContaining("can't be stepped now");
    }

    @Test
    void robotsAndThingsAreSpawnedUnderTheirNames() {
        assertThat(all(RunControl::spawnables))
                .extracting(Spawnable::name)
                .contains("pioneer2dx", "turtlebot3-burger", "box", "ball");
        assertThat(order(paused -> paused.spawn("pioneer3at", "visitor", THERE)))
                .isEqualTo(PLACED);
        assertThat(order(paused -> paused.spawn("box", "crate", new Pose2d(-10, -1, 0))))
                .isEqualTo(PLACED);
        await(run.when(now -> now.robots().size() == 3 && now.things().size() == 1)
                .toCompletableFuture());
        assertThat(all(_ -> world.entities())).contains("visitor", "crate");
        assertThat(run.events(0))
                .filteredOn(event -> event.subject().equals("visitor"))
                .extracting(RunEvent::text)
                .containsExactly("added at (-8.00, -1.00, 0°) (by kept)");
        refused(ask(again -> again.spawn("box", "crate", new Pose2d(-4, -1, 0))), "names are unique");
        refused(ask(again -> again.spawn("tank", "t", THERE)), "There is no robot model 'tank'.");
        assertThat(all(end -> {
                    end.removeSpawned();
                    return world.entities();
                }))
                .doesNotContain("visitor", "crate")
                .contains("prey", "hunter-1");
        assertThat(all(free -> List.of(free.isFree("visitor"), free.isFree("crate"), free.isFree("prey"))))
                .containsExactly(false, true, false);
        refused(ask(again -> again.spawn("pioneer3at", "visitor", THERE)), "ids are used once");
        refused(ask(gone -> gone.remove("crate")), "There is no 'crate'");
    }

    private static void refused(Placement placement, String why) {
        assertThat(placement)
                .isInstanceOfSatisfying(
                        Placement.Refused.class,
                        refused -> assertThat(refused.why()).contains(why));
    }

    @Test
    void allIsPutBackToWhereItBegan() {
        pause();
        Pose2d preyBegan = began("prey");
        Pose2d hunterBegan = began("hunter-1");
        assertThat(order(paused -> paused.place("prey", THERE))).isEqualTo(PLACED);
        assertThat(order(paused -> paused.place("hunter-1", preyBegan))).isEqualTo(PLACED); // in the prey's way
        assertThat(all(RunControl::restore)).isEmpty();
        assertThat(truth("prey")).isEqualTo(preyBegan);
        assertThat(truth("hunter-1")).isEqualTo(hunterBegan);
        assertThat(order(paused -> paused.remove("prey"))).isEqualTo(PLACED);
        assertThat(all(RunControl::restore)).containsExactly("prey");
    }

    private Pose2d began(String robot) {
        return run.plan().robots().stream()
                .filter(planned -> planned.spec().id().equals(robot))
                .findFirst()
                .flatMap(planned -> planned.spec().mapFromBase())
                .orElseThrow();
    }

    @Test
    void aRunCanBeEnded() {
        ask(ending -> {
            ending.end();
            return true;
        });
        assertThat(Runs.result(run).outcome()).isEqualTo("stopped");
    }
}
