package rsal.bench.measurement;

import java.util.List;

/// Measures some of what an [rsal.bench.Area] is about.
public interface Bench {
    /// Names of what it measures, in its order.
    List<String> names();

    /// Measures what is asked for and tells each result as soon as it is known.
    void measure(BenchmarkRequest assignment);
}
