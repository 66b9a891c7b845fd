package rsal.environment;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.IntConsumer;
import org.jspecify.annotations.Nullable;
import rsal.data.OccupancyGrid;
import rsal.engine.SteppedWatch;
import rsal.engine.report.RunResult;

/// Many worlds of one environment. Each is a run of its own, so that what happens in one does not depend on the others,
/// nor on how many threads simulate them. Numbers of all worlds are in one array, world by world. Of one thread.
public final class Worlds implements AutoCloseable {
    private static final int MOST = 10_000;

    private final Blueprint blueprint;
    private final SteppedWatch watch;
    private final @Nullable Episode[] episodes;
    private final ExecutorService threads;
    private final boolean isParallel;
    private final int learners;
    private final int robots;
    private final int observed; // numbers of a learner
    private final int acted;
    private final float[] observations;
    private final float[] truth;
    private final int[] collisions;

    /// Begins an episode in each world.
    ///
    /// @param seeds of the first episodes, one for each world
    /// @param threads that simulate at once
    /// @throws rsal.settings.InvalidSettings when the scenario has errors
    /// @throws IllegalArgumentException when a robot lacks what an observation or an action needs
    public Worlds(Blueprint blueprint, long[] seeds, int threads) {
        this(blueprint, seeds, threads, new SteppedWatch());
    }

    /// The same, for somebody who looks whether agents return.
    public Worlds(Blueprint blueprint, long[] seeds, int threads, SteppedWatch watch) {
        if (seeds.length < 1 || seeds.length > MOST) {
            throw new IllegalArgumentException("There can be 1 to %d worlds, not '%d'.".formatted(MOST, seeds.length));
        }
        this.blueprint = blueprint;
        this.watch = watch;
        this.isParallel = threads > 1 && seeds.length > 1;
        this.threads = Executors.newFixedThreadPool(
                Math.max(1, threads),
                Thread.ofPlatform().daemon().name("world-", 1).factory());
        this.episodes = new @Nullable Episode[seeds.length];
        Episode first = Episode.begin(blueprint, seeds[0], watch);
        episodes[0] = first;
        Blueprint.Layout layout = first.layout();
        this.learners = layout.learners().size();
        this.robots = layout.robots().size();
        this.observed = blueprint.observed();
        this.acted = blueprint.acted();
        this.observations = new float[seeds.length * learners * observed];
        this.truth = new float[seeds.length * robots * Episode.TRUTH];
        this.collisions = new int[seeds.length * robots];
        look(0);
        each(world -> {
            if (world > 0) {
                reset(world, seeds[world]);
            }
        });
    }

    public Blueprint.Layout layout() {
        return episode(0).layout();
    }

    /// The map of all worlds.
    public OccupancyGrid map() {
        return episode(0).map();
    }

    public int count() {
        return episodes.length;
    }

    private Episode episode(int world) {
        Episode episode = episodes[world];
        if (episode == null) {
            throw new IllegalStateException("World '%d' has no episode.".formatted(world));
        }
        return episode;
    }

    /// Ends the episode of a world, and begins another one there.
    ///
    /// @throws IllegalArgumentException when it has another number of robots
    public void reset(int world, long seed) {
        Episode before = episodes[world];
        if (before != null) {
            episodes[world] = null;
            before.close();
        }
        Episode next = Episode.begin(blueprint, seed, watch);
        Blueprint.Layout layout = next.layout();
        if (layout.learners().size() != learners || layout.robots().size() != robots) {
            next.close();
            throw new IllegalArgumentException("An episode has %d robots, the first one had %d."
                    .formatted(layout.robots().size(), robots));
        }
        episodes[world] = next;
        look(world);
    }

    /// As [#reset(int, long)], of several worlds at once.
    ///
    /// @param which worlds
    /// @param seeds one for each of them
    public void reset(int[] which, long[] seeds) {
        parallel(which.length, i -> reset(which[i], seeds[i]));
    }

    /// Makes a step in each world that is not over.
    ///
    /// @param actions of all learners of all worlds
    /// @throws IllegalArgumentException when one is not finite, or is none of the choices; then no world has acted
    public void step(float[] actions) {
        int each = learners * acted;
        if (actions.length != each * count()) {
            throw new IllegalArgumentException(
                    "A step of %d worlds has %d numbers, not '%d'.".formatted(count(), each * count(), actions.length));
        }
        for (int world = 0; world < count(); world++) {
            episode(world).check(actions, world * each);
        }
        each(world -> {
            episode(world).step(actions, world * each);
            look(world);
        });
    }

    private void look(int world) {
        Episode episode = episode(world);
        episode.observe(observations, world * learners * observed);
        episode.truth(truth, world * robots * Episode.TRUTH);
        episode.collisions(collisions, world * robots);
    }

    private void each(IntConsumer task) {
        parallel(count(), task);
    }

    private void parallel(int tasks, IntConsumer task) {
        if (!isParallel) {
            for (int i = 0; i < tasks; i++) {
                task.accept(i);
            }
            return;
        }
        var running = new ArrayList<Future<?>>();
        for (int i = 0; i < tasks; i++) {
            int number = i;
            running.add(threads.submit(() -> task.accept(number)));
        }
        await(running);
    }

    /// Waits for all, also when one fails, so that no world is at work afterwards.
    private static void await(List<Future<?>> running) {
        RuntimeException failure = null;
        for (Future<?> each : running) {
            try {
                each.get();
            } catch (ExecutionException e) {
                RuntimeException why = e.getCause() instanceof RuntimeException known
                        ? known
                        : new IllegalStateException("A world failed.", e.getCause());
                failure = failure == null ? why : failure;
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                throw new IllegalStateException("The worlds were interrupted.", e);
            }
        }
        if (failure != null) {
            throw failure;
        }
    }

    /// What all learners of all worlds observe: the same array after each step.
    public float[] observations() {
        return observations;
    }

    /// The true poses of all robots of all worlds, as [Episode#truth(float[], int)]: the same array after each step.
    public float[] truth() {
        return truth;
    }

    /// How often all robots of all worlds have touched something in their episode: the same array after each step.
    public int[] collisions() {
        return collisions;
    }

    public boolean isOver(int world) {
        return episode(world).isOver();
    }

    /// How the scenario ended an episode: empty while it goes on.
    public String outcome(int world) {
        return episode(world).outcome().orElse("");
    }

    /// The metrics of the scenario in a world, as they are now.
    public Map<String, Double> metrics(int world) {
        return episode(world).metrics();
    }

    /// Names of all metrics of the scenario, also of those without a value.
    public List<String> metricNames() {
        return episode(0).metricNames();
    }

    /// Ends the episode of a world.
    public RunResult finish(int world) {
        return episode(world).finish();
    }

    @Override
    public void close() {
        threads.shutdown();
        for (Episode episode : episodes) {
            if (episode != null) {
                episode.close();
            }
        }
    }
}
