package rsal.bench;

import java.util.List;
import java.util.function.Consumer;

/// Benchmarks that belong together.
public interface Area {
    /// `sim`
    String name();

    /// Names of what it measures, in its order. They are dotted and stay, as people compare by them.
    List<String> names();

    /// Measures. Takes minutes.
    ///
    /// @param wanted names of what to measure
    /// @param repeats how often each is measured; the median counts
    /// @param results told of each as soon as it is known
    void measure(List<String> wanted, int repeats, Consumer<Result> results);

    /// All that there are.
    static List<Area> all() {
        return List.of(new SimArea());
    }
}
