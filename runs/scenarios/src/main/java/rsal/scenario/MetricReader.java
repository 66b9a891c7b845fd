package rsal.scenario;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import rsal.metric.MetricType;
import rsal.metric.QuantityType;
import rsal.metric.SignalType;
import rsal.scenario.condition.MetricWords;
import rsal.scenario.installed.Catalog;
import rsal.scenario.installed.PluginReader;
import rsal.settings.Arguments;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.PluginKind;
import rsal.settings.Problems;
import rsal.settings.Section;

/// Reads the metrics of a scenario: those that are installed, with what the scenario sets of them, and those in
/// files of its author's own.
final class MetricReader {
    static final String KEY = "metricTypes";

    private static final PluginKind KIND = PluginKind.of("metric", MetricType.class, List.of());

    private final Catalog catalog;
    private final PluginReader plugins;
    private final RobotNames robots;
    private final Problems problems;
    private boolean isIncomplete;

    MetricReader(Catalog catalog, FileSource files, RobotNames robots, Problems problems) {
        this.catalog = catalog;
        this.plugins = new PluginReader(catalog, files);
        this.robots = robots;
        this.problems = problems;
    }

    /// @param named keys of those that the scenario names
    private static List<PlannedMetric> installed(Catalog catalog, Set<String> named) {
        return catalog.metrics().values().stream()
                .filter(type -> !named.contains(type.key()))
                .filter(type -> type.parameters().stream()
                        .allMatch(parameter -> parameter.fallback().isPresent()))
                .map(type -> new PlannedMetric(type, Arguments.defaults(type.parameters())))
                .toList();
    }

    /// The words of metrics that were read. Any word may be of one that could not be read.
    MetricWords words(List<PlannedMetric> metrics) {
        List<MetricType> types = metrics.stream().map(PlannedMetric::type).toList();
        return MetricWords.of(types, isIncomplete || types.stream().anyMatch(PluginReader::isNotRun));
    }

    List<PlannedMetric> read(Section root) {
        var named = new HashSet<String>();
        var metrics = new ArrayList<PlannedMetric>();
        for (Section section : Format.groups(root, KEY)) {
            Optional<MetricType> read = type(section);
            if (read.isEmpty()) {
                isIncomplete = true;
                section.has(Format.PARAMETERS); // nobody knows what can be set
            }
            read.ifPresent(type -> {
                if (!named.add(type.key())) {
                    section.problem("type", "Metric '%s' is named twice.".formatted(type.key()), "Remove one.");
                }
                if (PluginReader.isNotRun(type)) {
                    section.has(Format.PARAMETERS);
                    metrics.add(new PlannedMetric(type, Arguments.defaults(List.of())));
                    return;
                }
                Section args = section.section(Format.PARAMETERS);
                args.arguments(type.parameters()).ifPresent(arguments -> {
                    robots.check(args, type.parameters(), arguments);
                    metrics.add(new PlannedMetric(type, arguments));
                });
            });
            section.done();
        }
        List<PlannedMetric> all = Stream.concat(installed(catalog, named).stream(), metrics.stream())
                .toList();
        checkWords(all, root.locationOf(KEY));
        return all;
    }

    /// One that is installed, or that the scenario's author wrote; empty when it can't be read.
    private Optional<MetricType> type(Section section) {
        String name = section.text("type");
        if (name.isEmpty()) {
            return Optional.empty();
        }
        Location at = section.locationOf("type");
        try {
            Optional<MetricType> own = plugins.read(KIND, name, at).map(MetricType.class::cast);
            return own.isPresent() ? own : Catalog.find("metric", catalog.metrics(), name, at, problems);
        } catch (InvalidSettings e) {
            problems.addAll(e);
            return Optional.empty();
        }
    }

    /// A word means one thing.
    private void checkWords(List<PlannedMetric> metrics, Location at) {
        Map<String, String> owners = new HashMap<>();
        MetricWords.OF_RUNS.quantities().forEach(type -> owners.put(type.word(), "every run"));
        MetricWords.OF_RUNS.signals().forEach(type -> owners.put(type.word(), "every run"));
        for (PlannedMetric metric : metrics) {
            MetricType type = metric.type();
            Stream.concat(
                            type.quantities().stream().map(QuantityType::word),
                            type.signals().stream().map(SignalType::word))
                    .forEach(word -> {
                        String other = owners.putIfAbsent(word, "metric '%s'".formatted(type.key()));
                        if (other != null) {
                            problems.add(
                                    at,
                                    "Metric '%s' offers '%s', which %s offers already."
                                            .formatted(type.key(), word, other),
                                    "Give it another word.");
                        }
                    });
        }
    }
}
