package rsal.bench.measurement;

import java.util.List;

/// A picture of what was measured, for a report.
public sealed interface Plot {
    String title();

    /// What is along its axes, with units.
    String x();

    String y();

    /// Values over a number, as errors over time: a line for each series.
    record Lines(String title, String x, String y, List<Point> points) implements Plot {
        /// @param series whose line it is on
        public record Point(String series, double x, double y) {}

        public Lines {
            points = List.copyOf(points);
        }
    }

    /// Values of things with names, as times by map: a bar for each, side by side for each series.
    record Bars(String title, String x, String y, List<Bar> bars) implements Plot {
        public record Bar(String series, String name, double value) {}

        public Bars {
            bars = List.copyOf(bars);
        }
    }

    /// Values from 0 to 1 in a table of colors, as successes by planner and world.
    ///
    /// @param value what the colors mean
    record Shares(String title, String x, String y, String value, List<Share> shares) implements Plot {
        public record Share(String row, String column, double value) {}

        public Shares {
            shares = List.copyOf(shares);
        }
    }
}
