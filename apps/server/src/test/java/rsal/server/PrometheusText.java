package rsal.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/// Reads the text format of Prometheus, version 0.0.4, more strictly than Prometheus does: each metric has its `HELP`
/// and `TYPE` first, its lines together, a name that suits its type, and a histogram's buckets rise and are whole.
///
/// @param types by name of the metric
/// @param values by name and labels, as `name{one="a",two="b"}` with the labels in order
record PrometheusText(Map<String, String> types, Map<String, Double> values) {
    private static final Pattern NAME = Pattern.compile("[a-zA-Z_:][a-zA-Z0-9_:]*");
    private static final Pattern LABEL =
            Pattern.compile("([a-zA-Z_][a-zA-Z0-9_]*)=\"((?:[^\"\\\\\n]|\\\\[\\\\\"n])*)\"(,|})");
    private static final Pattern NUMBER = Pattern.compile("[+-]?(?:[0-9]+(?:\\.[0-9]*)?(?:[eE][+-]?[0-9]+)?|Inf)|NaN");
    private static final Set<String> TYPES = Set.of("counter", "gauge", "histogram", "summary");

    static PrometheusText read(String text) {
        assertThat(text).endsWith("\n").doesNotContain("\r", "\n\n");
        var types = new LinkedHashMap<String, String>();
        var values = new LinkedHashMap<String, Double>();
        var buckets = new LinkedHashMap<String, List<Bucket>>();
        String metric = "";
        String[] lines = text.split("\n", 0);
        for (int i = 0; i < lines.length; i++) {
            String line = lines[i];
            if (line.startsWith("# HELP ")) {
                String[] words = line.split(" ", 4);
                metric = words[2];
                assertThat(metric).matches(NAME);
                assertThat(words[3]).as(line).isNotBlank();
                assertThat(lines[i + 1]).as("after " + line).startsWith("# TYPE " + metric + " ");
                String type = lines[++i].split(" ", 0)[3];
                assertThat(TYPES).contains(type);
                assertThat(types.put(metric, type)).as(metric).isNull();
                assertThat(metric.endsWith("_total")).as(metric).isEqualTo(type.equals("counter"));
            } else {
                Sample sample = sample(line);
                assertThat(metric).as("type of " + line).isNotEmpty();
                assertThat(suffixes(types.get(metric)).stream().map(metric::concat))
                        .as(line)
                        .contains(sample.name);
                if (sample.name.equals(metric + "_bucket")) {
                    String bound = sample.labels.remove("le");
                    assertThat(bound).as(line).isNotNull();
                    buckets.computeIfAbsent(metric + words(sample.labels), _ -> new ArrayList<>())
                            .add(new Bucket(number(bound), sample.value));
                } else {
                    assertThat(values.put(sample.name + words(sample.labels), sample.value))
                            .as(line)
                            .isNull();
                }
            }
        }
        buckets.forEach((series, all) -> check(series, all, values));
        return new PrometheusText(types, values);
    }

    private record Bucket(double bound, double count) {}

    private record Sample(String name, Map<String, String> labels, double value) {}

    private static List<String> suffixes(String type) {
        return switch (type) {
            case "histogram" -> List.of("_bucket", "_sum", "_count");
            case "summary" -> List.of("", "_sum", "_count");
            default -> List.of("");
        };
    }

    private static Sample sample(String line) {
        Matcher name = NAME.matcher(line);
        assertThat(name.lookingAt()).as(line).isTrue();
        int at = name.end();
        var labels = new TreeMap<String, String>();
        if (line.charAt(at) == '{') {
            Matcher label = LABEL.matcher(line);
            do {
                assertThat(label.find(at + 1) && label.start() == at + 1)
                        .as(line)
                        .isTrue();
                assertThat(labels.put(label.group(1), label.group(2))).as(line).isNull();
                at = label.end() - 1;
            } while (line.charAt(at) == ',');
            at++;
        }
        assertThat(line.charAt(at)).as(line).isEqualTo(' ');
        return new Sample(name.group(), labels, number(line.substring(at + 1)));
    }

    private static double number(String text) {
        assertThat(text).matches(NUMBER);
        return Double.parseDouble(text.replace("Inf", "Infinity"));
    }

    private static String words(Map<String, String> labels) {
        return labels.isEmpty()
                ? ""
                : labels.entrySet().stream()
                        .map(label -> label.getKey() + "=\"" + label.getValue() + "\"")
                        .collect(Collectors.joining(",", "{", "}"));
    }

    private static void check(String series, List<Bucket> buckets, Map<String, Double> values) {
        assertThat(buckets).as(series).isSortedAccordingTo((one, next) -> Double.compare(one.bound, next.bound));
        assertThat(buckets).as(series).isSortedAccordingTo((one, next) -> Double.compare(one.count, next.count));
        assertThat(buckets.getLast().bound).as(series).isEqualTo(Double.POSITIVE_INFINITY);
        assertThat(buckets.getLast().count)
                .as(series)
                .isEqualTo(values.get(series.replaceFirst("(\\{|$)", "_count$1")));
    }

    double value(String series) {
        assertThat(values).containsKey(series);
        return values.get(series);
    }

    /// What only grows: counters, and what histograms and summaries count.
    Map<String, Double> growing() {
        var growing = new TreeMap<String, Double>();
        types.forEach((metric, type) -> {
            if (!type.equals("gauge")) {
                values.forEach((series, value) -> {
                    if (series.matches(Pattern.quote(metric) + "(_sum|_count)?(\\{.*)?")) {
                        growing.put(series, value);
                    }
                });
            }
        });
        return growing;
    }
}
