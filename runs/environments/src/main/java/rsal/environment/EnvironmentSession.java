package rsal.environment;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.data.OccupancyGrid;
import rsal.engine.SteppedWatch;
import rsal.engine.report.RunResult;
import rsal.scenario.RunOptions;

/// The worlds of one program outside, which asks in words and arrays. It answers each request before it gets the next.
/// Of one thread.
///
/// | Request | Words | Answer |
/// |---|---|---|
/// | `open` | `scenario`, `configuration`, `arguments`, `learners`, `observe`, `act`, `steps`, `seeds`, `threads` | the
/// layout; all arrays |
/// | `step` | array: the actions of all learners | `over`: the worlds that are over and how; all arrays |
/// | `reset` | `worlds`, `seeds` | all arrays |
/// | `metrics` | | `metrics` of each world |
/// | `finish` | `world` | `outcome`, `seconds`, `metrics`, `eventHash`, `failed` agents |
/// | `map` | | `width`, `height`, `resolution` [m], `origin` [m]; array: its cells |
///
/// The request `close` is of those who have a process: it ends with it.
///
/// All arrays are the observations, the true poses (both 32-bit numbers) and the collisions (32-bit integers) of all
/// worlds ([Worlds]).
public final class EnvironmentSession implements AutoCloseable {
    private final Environments environments = new Environments();
    private final SteppedWatch watch;
    private @Nullable Worlds worlds;

    public EnvironmentSession() {
        this(new SteppedWatch());
    }

    /// @param watch for those who look whether agents return
    public EnvironmentSession(SteppedWatch watch) {
        this.watch = watch;
    }

    /// @param words texts, numbers, flags, lists and maps
    /// @param arrays each a `float[]`, an `int[]` or a `byte[]`
    public record Answer(Map<String, Object> words, List<Object> arrays) {}

    /// @param actions the array of the request; empty without one
    /// @throws rsal.settings.InvalidSettings when the scenario has errors
    /// @throws IllegalArgumentException in a sentence for people, for all other errors
    public Answer answer(Map<?, ?> words, float[] actions) {
        String request = text(words, "request", "");
        return switch (request) {
            case "open" -> open(words);
            case "step" -> step(actions);
            case "reset" -> reset(words);
            case "metrics" -> metrics();
            case "finish" -> finish(integer(words, "world", 0));
            case "map" -> map();
            default -> throw new IllegalArgumentException("There is no request '%s'.".formatted(request));
        };
    }

    private Worlds worlds() {
        Worlds known = worlds;
        if (known == null) {
            throw new IllegalArgumentException("The first request must be 'open'.");
        }
        return known;
    }

    private Answer open(Map<?, ?> words) {
        close();
        var options = RunOptions.NONE.withArguments(texts(words.get("arguments")));
        String configuration = text(words, "configuration", "");
        Blueprint blueprint = environments.read(
                text(words, "scenario", ""),
                configuration.isEmpty() ? options : options.withConfiguration(configuration),
                text(words, "learners", ""),
                maps(words.get("observe")),
                map(words.get("act")),
                integer(words, "steps", 1));
        long[] seeds = numbers(words.get("seeds"));
        var opened = new Worlds(blueprint, seeds, integer(words, "threads", 1), watch);
        worlds = opened;
        Blueprint.Layout layout = opened.layout();
        var fields = new ArrayList<String>();
        var low = new ArrayList<Float>();
        var high = new ArrayList<Float>();
        for (LearnerObservation observation : blueprint.observations()) {
            fields.addAll(observation.fields());
            low.addAll(list(observation.low()));
            high.addAll(list(observation.high()));
        }
        var answer = new LinkedHashMap<String, Object>();
        answer.put("learners", layout.learners());
        answer.put("robots", layout.robots());
        answer.put("colors", layout.colors());
        answer.put("period", layout.period());
        answer.put("fields", fields);
        answer.put("low", low);
        answer.put("high", high);
        answer.put("actionFields", blueprint.action().fields());
        answer.put("actionLow", list(blueprint.action().low()));
        answer.put("actionHigh", list(blueprint.action().high()));
        answer.put("choices", blueprint.action().choices());
        answer.put("metrics", opened.metricNames());
        return new Answer(answer, arrays(opened));
    }

    private Answer step(float[] actions) {
        Worlds all = worlds();
        all.step(actions);
        Map<String, Object> over = new LinkedHashMap<>();
        for (int world = 0; world < all.count(); world++) {
            if (all.isOver(world)) {
                over.put(String.valueOf(world), all.outcome(world));
            }
        }
        return new Answer(over.isEmpty() ? Map.of() : Map.of("over", over), arrays(all));
    }

    private Answer reset(Map<?, ?> words) {
        Worlds all = worlds();
        long[] seeds = numbers(words.get("seeds"));
        long[] which = numbers(words.get("worlds"));
        if (which.length != seeds.length) {
            throw new IllegalArgumentException(
                    "Each of %d worlds needs a seed; there are %d.".formatted(which.length, seeds.length));
        }
        var numbers = new int[which.length];
        for (int i = 0; i < which.length; i++) {
            numbers[i] = Objects.checkIndex(Math.toIntExact(which[i]), all.count());
        }
        all.reset(numbers, seeds);
        return new Answer(Map.of(), arrays(all));
    }

    private Answer metrics() {
        Worlds all = worlds();
        var metrics = new ArrayList<Map<String, Double>>();
        for (int world = 0; world < all.count(); world++) {
            metrics.add(all.metrics(world));
        }
        return new Answer(Map.of("metrics", metrics), List.of());
    }

    private Answer finish(int world) {
        RunResult result = worlds().finish(Objects.checkIndex(world, worlds().count()));
        var metrics = new LinkedHashMap<String, Double>();
        result.metrics().forEach((name, value) -> value.ifPresent(known -> metrics.put(name, known)));
        return new Answer(
                Map.of(
                        "outcome", result.outcome(),
                        "seconds", result.simulatedSeconds(),
                        "metrics", metrics,
                        "eventHash", result.eventHash(),
                        "failed", result.failed()),
                List.of());
    }

    private Answer map() {
        OccupancyGrid map = worlds().map();
        return new Answer(
                Map.of(
                        "width", map.width(),
                        "height", map.height(),
                        "resolution", map.resolution(),
                        "origin", List.of(map.originX(), map.originY())),
                List.of(map.cells()));
    }

    private static List<Object> arrays(Worlds all) {
        return List.of(all.observations(), all.truth(), all.collisions());
    }

    private static List<Float> list(float[] numbers) {
        var list = new ArrayList<Float>();
        for (float number : numbers) {
            list.add(number);
        }
        return list;
    }

    private static String text(Map<?, ?> words, String name, String fallback) {
        return words.get(name) instanceof String text ? text : fallback;
    }

    private static int integer(Map<?, ?> words, String name, int fallback) {
        return words.get(name) instanceof Number number ? Math.toIntExact(number.longValue()) : fallback;
    }

    private static long[] numbers(@Nullable Object words) {
        if (!(words instanceof List<?> list) || !list.stream().allMatch(Number.class::isInstance)) {
            throw new IllegalArgumentException("Seeds and worlds must be lists of numbers, not '%s'.".formatted(words));
        }
        return list.stream()
                .map(Number.class::cast)
                .mapToLong(Number::longValue)
                .toArray();
    }

    private static Map<String, Object> map(@Nullable Object words) {
        var map = new LinkedHashMap<String, Object>();
        if (words instanceof Map<?, ?> given) {
            given.forEach((name, value) -> map.put(String.valueOf(name), value));
        }
        return map;
    }

    private static List<Map<String, Object>> maps(@Nullable Object words) {
        return words instanceof List<?> list
                ? list.stream().map(EnvironmentSession::map).toList()
                : List.of();
    }

    private static Map<String, String> texts(@Nullable Object words) {
        var texts = new LinkedHashMap<String, String>();
        map(words).forEach((name, value) -> texts.put(name, String.valueOf(value)));
        return texts;
    }

    /// Ends all worlds.
    @Override
    public void close() {
        Optional.ofNullable(worlds).ifPresent(Worlds::close);
        worlds = null;
    }
}
