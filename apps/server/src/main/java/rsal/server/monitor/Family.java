package rsal.server.monitor;

import io.prometheus.metrics.model.snapshots.CounterSnapshot;
import io.prometheus.metrics.model.snapshots.CounterSnapshot.CounterDataPointSnapshot;
import io.prometheus.metrics.model.snapshots.GaugeSnapshot;
import io.prometheus.metrics.model.snapshots.GaugeSnapshot.GaugeDataPointSnapshot;
import io.prometheus.metrics.model.snapshots.Labels;
import io.prometheus.metrics.model.snapshots.MetricSnapshot;
import java.time.Duration;
import java.util.List;
import java.util.Locale;

/// Makes metrics as Prometheus has them, one or more numbers under one name.
public final class Family {
    private Family() {}

    /// One of the numbers.
    public record Sample(double value, Labels labels) {
        /// @param labels their names and values, in turn
        public static Sample of(double value, String... labels) {
            return new Sample(value, Labels.of(labels));
        }

        /// A count, which Prometheus has as a `double`, too: exact to 9e15.
        public static Sample of(long count, String... labels) {
            return of((double) count, labels);
        }
    }

    /// What only grows.
    ///
    /// @param name with its unit and `_total`
    public static MetricSnapshot counter(String name, String help, List<Sample> samples) {
        var family = CounterSnapshot.builder().name(name).help(help);
        samples.forEach(sample -> family.dataPoint(CounterDataPointSnapshot.builder()
                .value(sample.value())
                .labels(sample.labels())
                .build()));
        return family.build();
    }

    public static MetricSnapshot counter(String name, String help, double value) {
        return counter(name, help, List.of(Sample.of(value)));
    }

    public static MetricSnapshot counter(String name, String help, long count) {
        return counter(name, help, (double) count);
    }

    /// What goes up and down.
    ///
    /// @param name with its unit
    static MetricSnapshot gauge(String name, String help, List<Sample> samples) {
        var family = GaugeSnapshot.builder().name(name).help(help);
        samples.forEach(sample -> family.dataPoint(GaugeDataPointSnapshot.builder()
                .value(sample.value())
                .labels(sample.labels())
                .build()));
        return family.build();
    }

    static MetricSnapshot gauge(String name, String help, double value) {
        return gauge(name, help, List.of(Sample.of(value)));
    }

    static MetricSnapshot gauge(String name, String help, long count) {
        return gauge(name, help, (double) count);
    }

    /// Whether something is so.
    static MetricSnapshot gauge(String name, String help, boolean value) {
        return gauge(name, help, value ? 1 : 0);
    }

    static double seconds(Duration duration) {
        return duration.toNanos() / 1e9;
    }

    /// A constant as the value of a label.
    static String word(Enum<?> constant) {
        return constant.name().toLowerCase(Locale.ROOT);
    }
}
