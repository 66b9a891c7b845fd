package rsal.world.yaml;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rsal.data.Pose2d;
import rsal.settings.Section;
import rsal.settings.Value;

/// Where something stands: a pose, and how high above the floor its underside is [m].
record FloorPlace(Pose2d pose, double height) {
    static final FloorPlace ORIGIN = new FloorPlace(Pose2d.ORIGIN, 0);

    /// `[x, y, degrees]` or `[x, y, degrees, height]`; empty when an error was noted.
    static Optional<FloorPlace> read(Section section, String key, Value value) {
        boolean high = value instanceof Value.Sequence list && list.items().size() == 4;
        Optional<double[]> numbers = section.numbers(key, value, high ? 4 : 3);
        for (double number : numbers.orElse(new double[0])) {
            if (!(Math.abs(number) <= Keys.FARTHEST)) {
                section.problem(
                        value.location(),
                        "'%s' must be within %.0f m.".formatted(section.path(key), Keys.FARTHEST),
                        "");
                return Optional.empty();
            }
        }
        return numbers.map(n -> new FloorPlace(Pose2d.ofDegrees(n[0], n[1], n[2]), high ? n[3] : 0));
    }

    /// The one under a key; the origin when it isn't given or wrong.
    static FloorPlace one(Section section, String key) {
        return section.find(key).flatMap(value -> read(section, key, value)).orElse(ORIGIN);
    }

    /// Several: a list of places, or a row, `{first: [x, y, degrees], step: [x, y]}`.
    ///
    /// @param count how many; 0 for as many as are listed
    static List<FloorPlace> several(Section section, String key, int count) {
        if (section.isMapping(key)) {
            return row(section.section(key), count);
        }
        var places = new ArrayList<FloorPlace>();
        List<Value> listed = section.find(key)
                .map(value -> isList(value) ? ((Value.Sequence) value).items() : List.of(value))
                .orElse(List.of());
        listed.forEach(value -> read(section, key, value).ifPresent(places::add));
        if (places.size() < listed.size()) {
            return List.of();
        }
        if (count > listed.size()) {
            section.problem(
                    key,
                    "'%s' has %d for %d.".formatted(section.path(key), listed.size(), count),
                    "List more of them.");
        }
        return count > 0 && count < places.size() ? List.copyOf(places.subList(0, count)) : List.copyOf(places);
    }

    /// An area, `[left, bottom, right, top]` [m]; empty when there is none, or an error was noted.
    static Optional<double[]> area(Section section, String key) {
        Optional<double[]> area = section.numbers(key, 4);
        for (double side : area.orElse(new double[0])) {
            if (!(Math.abs(side) <= Keys.FARTHEST)) {
                section.problem(key, "'%s' must be within %.0f m.".formatted(section.path(key), Keys.FARTHEST), "");
                return Optional.empty();
            }
        }
        if (area.isPresent() && !(area.get()[0] < area.get()[2] && area.get()[1] < area.get()[3])) {
            section.problem(
                    key, "'%s' must be [left, bottom, right, top], the least first.".formatted(section.path(key)), "");
            return Optional.empty();
        }
        return area;
    }

    /// Whether a value lists places rather than being one.
    static boolean isList(Value value) {
        return value instanceof Value.Sequence list
                && !list.items().isEmpty()
                && list.items().stream().allMatch(Value.Sequence.class::isInstance);
    }

    private static List<FloorPlace> row(Section row, int count) {
        FloorPlace first = one(row, "first");
        double[] step = row.numbers("step", 2).orElse(new double[2]);
        if (!row.has("first") || !row.has("step")) {
            row.problem(
                    row.location(),
                    "'%s' must have 'first' and 'step'.".formatted(row.path("")),
                    "{first: [0, 0, 90], step: [1, 0]}");
        }
        if (!(Math.abs(step[0]) <= Keys.FARTHEST && Math.abs(step[1]) <= Keys.FARTHEST)) {
            row.problem("step", "'%s' must be within %.0f m.".formatted(row.path("step"), Keys.FARTHEST), "");
            return List.of();
        }
        row.done();
        var places = new ArrayList<FloorPlace>();
        for (int i = 0; i < count; i++) {
            Pose2d pose = first.pose;
            places.add(new FloorPlace(
                    new Pose2d(pose.x() + i * step[0], pose.y() + i * step[1], pose.theta()), first.height));
        }
        return places;
    }
}
