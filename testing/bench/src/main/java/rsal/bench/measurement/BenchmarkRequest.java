package rsal.bench.measurement;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Consumer;

/// What benchmarks are to measure, with what, and whom they tell.
///
/// @param wanted names of what to measure
/// @param often how often each is to be measured; empty for as often as is usual
/// @param episodes how many episodes are made of which memory is measured
/// @param data where public data is: folders `logs`, `maps` and `barn`
/// @param results told of each as soon as it is known
/// @param plots told of each picture of them
/// @param notes told what is left out and why
/// @param progress told how far something is that takes long, perhaps many times a second and by several threads
public record BenchmarkRequest(
        Set<String> wanted,
        OptionalInt often,
        int episodes,
        Optional<Path> data,
        Consumer<Result> results,
        Consumer<Plot> plots,
        Consumer<String> notes,
        Consumer<String> progress) {
    /// How often is usual where the median counts.
    public static final int REPEATS = 5;

    /// How often is usual where ways of doing something are compared in runs with equal seeds.
    public static final int SEEDS = 30;

    /// How many episodes are usual.
    public static final int EPISODES = 2000;

    public BenchmarkRequest {
        wanted = Set.copyOf(wanted);
    }

    public boolean wants(String name) {
        return wanted.contains(name);
    }

    public boolean wantsAny(Collection<String> names) {
        return names.stream().anyMatch(this::wants);
    }

    /// How often each is measured of which the median counts.
    public int repeats() {
        return often.orElse(REPEATS);
    }

    /// With how many seeds runs are made of which the mean counts.
    public int seeds() {
        return often.orElse(SEEDS);
    }

    /// Tells results that are asked for.
    public void report(Collection<Result> measured) {
        measured.stream().filter(result -> wants(result.name())).forEach(results);
    }

    public void report(Result... measured) {
        report(List.of(measured));
    }

    public void show(Plot plot) {
        plots.accept(plot);
    }

    /// Tells how far something is.
    ///
    /// @param what of it is done; told of `of`
    public void reach(String name, int what, int of) {
        progress.accept("%s: %d of %d".formatted(name, what, of));
    }

    /// A file of the public data; when it isn't there, those who asked are told that something is left out.
    ///
    /// @param name `logs/aces-corrected.log.gz`
    public Optional<Path> data(String name) {
        Optional<Path> file = data.map(folder -> folder.resolve(name)).filter(Files::isReadable);
        if (file.isEmpty()) {
            notes.accept("Skipped what needs '%s': name the folder of the public data by '--data'.".formatted(name));
        }
        return file;
    }
}
