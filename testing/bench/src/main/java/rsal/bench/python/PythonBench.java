package rsal.bench.python;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import rsal.bench.measurement.Bench;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.MeasurementFailed;
import rsal.bench.measurement.Result;

/// Agents and learning environments in Python, beside environments of others, in one process of Python
/// ([PythonProgram]). What is not installed there is left out, and those who asked are told what to install.
public final class PythonBench implements Bench {
    private static final String RATE = "1/s";

    /// @param better `more` or `less`
    /// @param goal which the median is to reach
    private record Row(String name, String unit, String better, OptionalDouble goal) {
        static Row more(String name, String unit, double goal) {
            return new Row(name, unit, "more", OptionalDouble.of(goal));
        }

        static Row less(String name, String unit, double goal) {
            return new Row(name, unit, "less", OptionalDouble.of(goal));
        }

        static Row peer(String name) {
            return new Row(name, RATE, "more", OptionalDouble.empty());
        }

        Result result(double... values) {
            Result result = better.equals("more") ? Result.more(name, unit, values) : Result.less(name, unit, values);
            return goal.isPresent() ? result.toReach(goal.getAsDouble()) : result;
        }
    }

    private static final List<Row> ROWS = List.of(
            Row.less("python.import.ms", "ms", 50),
            Row.less("python.agent.callback.p50", "us", 20),
            new Row("python.agent.callback.p99", "us", "less", OptionalDouble.empty()),
            Row.more("python.agent.scans.rtf", "s/s", 100),
            new Row("python.env.first.s", "s", "less", OptionalDouble.empty()),
            Row.more("python.env.pettingzoo.10.agents", RATE, 60_000),
            new Row("python.env.vector.1x10.agents", RATE, "more", OptionalDouble.empty()),
            Row.less("python.env.transport.share", "", 0.1),
            Row.more("python.env.vector.16x10.agents", RATE, 85_000),
            Row.more("python.env.vector.1x100.agents", RATE, 80_000),
            Row.less("python.env.reset.lasers.ms", "ms", 3),
            Row.less("python.env.reset.hunt.ms", "ms", 12),
            new Row("python.env.episodes.java.mb", "MB", "less", OptionalDouble.empty()),
            new Row("python.env.episodes.python.mb", "MB", "less", OptionalDouble.empty()),
            Row.less("python.env.episodes.files", "", 0),
            Row.peer("python.peer.mpe.10.agents"),
            Row.peer("python.peer.sisl.8.agents"),
            Row.peer("python.peer.irsim.10.agents"));

    @Override
    public List<String> names() {
        return ROWS.stream().map(Row::name).toList();
    }

    @Override
    public void measure(BenchmarkRequest assignment) {
        List<String> wanted = names().stream().filter(assignment::wants).toList();
        if (wanted.isEmpty()) {
            return;
        }
        Map<String, Row> rows = new HashMap<>();
        ROWS.forEach(row -> rows.put(row.name(), row));
        new PythonProgram(wanted, assignment.repeats(), assignment.episodes()).run(line -> {
            Row row = rows.get(line.name());
            if (row == null) {
                throw new MeasurementFailed("Python told of '%s', which nobody asked for.".formatted(line.name()));
            }
            if (line.values().length > 0) {
                assignment.report(row.result(line.values()));
            } else {
                assignment.notes().accept("'%s' is left out: %s.".formatted(line.name(), line.note()));
            }
        });
    }
}
