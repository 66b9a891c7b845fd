package rsal.experiment;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import rsal.scenario.text.CsvLine;
import rsal.settings.Parameter;

/// Rows as CSV: the same columns in all of them. Arguments and metrics
/// may have the same names, so each says which it is.
record CsvTable(List<String> arguments, List<String> metrics) {
    static CsvTable of(Sweep sweep) {
        return new CsvTable(
                sweep.scenario().arguments().stream().map(Parameter::name).toList(), sweep.valueNames());
    }

    String header() {
        var names = new ArrayList<>(List.of("run", "combination", "configuration"));
        arguments.forEach(name -> names.add("argument." + name));
        names.addAll(List.of("seed", "outcome", "reason", "simulatedSeconds", "wallSeconds", "eventHash"));
        metrics.forEach(name -> names.add("metric." + name));
        names.addAll(List.of("outOfBounds", "failedAgents"));
        return CsvLine.of(names.stream());
    }

    String line(Row row) {
        var cells = new ArrayList<>(
                List.of(Integer.toString(row.run()), Integer.toString(row.combination()), row.configuration()));
        arguments.forEach(name -> cells.add(String.valueOf(row.arguments().getOrDefault(name, ""))));
        cells.addAll(List.of(
                Long.toString(row.seed()),
                row.outcome(),
                row.reason(),
                number(row.simulatedSeconds()),
                number(row.wallSeconds()),
                row.eventHash()));
        metrics.forEach(name -> cells.add(number(row.metrics().getOrDefault(name, OptionalDouble.empty()))));
        cells.add(String.join("; ", row.outOfBounds()));
        cells.add(row.failedAgents().entrySet().stream()
                .map(agent -> agent.getKey() + ": " + agent.getValue())
                .collect(Collectors.joining("; ")));
        return CsvLine.of(cells.stream());
    }

    /// Whole numbers as they are, all others as exactly as they are known.
    private static String number(OptionalDouble value) {
        if (value.isEmpty()) {
            return "";
        }
        double number = value.getAsDouble();
        return number == Math.rint(number) && Math.abs(number) < 1e15
                ? Long.toString((long) number)
                : Double.toString(number);
    }
}
