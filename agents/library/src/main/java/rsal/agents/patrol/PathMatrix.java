package rsal.agents.patrol;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.stream.IntStream;
import rsal.agents.driving.PlannedPaths;
import rsal.data.Pose2d;
import rsal.time.Scheduler;

/// Lengths of the paths between all places, by a robot's planner. A place from which no path leads anywhere is
/// asked for again, twice at most: its planner may have failed once, as while its robot is not there yet.
final class PathMatrix {
    private static final int TRIES = 3;
    private static final Duration PAUSE = Duration.ofSeconds(1);

    private final PlannedPaths paths;
    private final List<Pose2d> mapFromPlaces;
    private final Scheduler scheduler;
    private final List<List<Double>> rows = new ArrayList<>();

    private PathMatrix(PlannedPaths paths, List<Pose2d> mapFromPlaces, Scheduler scheduler) {
        this.paths = paths;
        this.mapFromPlaces = mapFromPlaces;
        this.scheduler = scheduler;
        mapFromPlaces.forEach(_ -> rows.add(List.of()));
    }

    /// Row-major, the same in both directions [m]; +∞ where no path leads either way.
    static CompletionStage<double[]> of(PlannedPaths paths, List<Pose2d> mapFromPlaces, Scheduler scheduler) {
        var matrix = new PathMatrix(paths, mapFromPlaces, scheduler);
        List<Integer> all = IntStream.range(0, mapFromPlaces.size()).boxed().toList();
        return matrix.ask(all, 1).thenApply(PathMatrix::symmetric);
    }

    private CompletionStage<PathMatrix> ask(List<Integer> places, int count) {
        CompletionStage<PathMatrix> asked = CompletableFuture.completedStage(this);
        for (int place : places) {
            asked = asked.thenCompose(_ -> paths.costs(mapFromPlaces.get(place), mapFromPlaces))
                    .thenApply(row -> {
                        rows.set(place, row);
                        return this;
                    });
        }
        return asked.thenCompose(_ -> again(places, count));
    }

    private CompletionStage<PathMatrix> again(List<Integer> places, int count) {
        List<Integer> cut = places.stream().filter(this::isCut).toList();
        if (cut.isEmpty() || count == TRIES) {
            return CompletableFuture.completedStage(this);
        }
        var later = new CompletableFuture<List<Integer>>();
        scheduler.after(PAUSE, () -> later.complete(cut));
        return later.thenCompose(some -> ask(some, count + 1));
    }

    /// Whether no path leads from a place to any other.
    private boolean isCut(int from) {
        return rows.size() > 1
                && IntStream.range(0, rows.size())
                        .noneMatch(to ->
                                to != from && Double.isFinite(rows.get(from).get(to)));
    }

    private double[] symmetric() {
        int size = rows.size();
        var lengths = new double[size * size];
        for (int from = 0; from < size; from++) {
            for (int to = 0; to < size; to++) {
                double there = rows.get(from).get(to);
                double back = rows.get(to).get(from);
                double mean = (there + back) / 2;
                lengths[from * size + to] = from == to ? 0 : Double.isFinite(mean) ? mean : Math.min(there, back);
            }
        }
        return lengths;
    }
}
