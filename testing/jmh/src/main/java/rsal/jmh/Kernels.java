package rsal.jmh;

import java.util.Collection;
import java.util.TreeMap;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.CommandLineOptionException;
import org.openjdk.jmh.runner.options.CommandLineOptions;

/// Runs benchmarks and says how many times faster each kernel is than its slow and obvious version, measured in the
/// same run: benchmarks of one class, `kernel` and `slow`. Takes JMH's options; a name chooses some.
public final class Kernels {
    private Kernels() {}

    public static void main(String[] args) throws CommandLineOptionException, RunnerException {
        Collection<RunResult> results = new Runner(new CommandLineOptions(args)).run();
        var scores = new TreeMap<String, Double>();
        results.forEach(
                result -> scores.put(name(result), result.getPrimaryResult().getScore()));
        scores.forEach((name, score) -> {
            Double slow = scores.get(name.replace(".kernel", ".slow"));
            if (name.contains(".kernel") && slow != null) {
                System.out.printf(
                        "%-50s %8.1f times as fast as the slow one%n", name.replace(".kernel", ""), score / slow);
            }
        });
    }

    private static String name(RunResult result) {
        var params = result.getParams();
        var name = new StringBuilder(params.getBenchmark().replaceFirst(".*\\.(\\w+\\.\\w+)$", "$1"));
        params.getParamsKeys().forEach(key -> name.append(' ').append(params.getParam(key)));
        return name.toString();
    }
}
