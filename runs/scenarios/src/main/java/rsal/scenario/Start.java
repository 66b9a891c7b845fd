package rsal.scenario;

import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import rsal.data.FreeSpace;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.scenario.installed.MapFacts;
import rsal.settings.Section;
import rsal.settings.Value;

/// Where the robots or things of a group are at first: at poses that are written, or somewhere free.
///
/// @param fixed as many as there are of them, or none
/// @param free where to look for places; empty when there are poses, or nothing is said
record Start(List<Pose2d> fixed, Optional<Free> free) {
    /// Nothing is said.
    static final Start OPEN = new Start(List.of(), Optional.empty());

    /// @param count of them
    /// @param what they are, for messages: `robots`
    static Start read(Section section, int count, String what) {
        Optional<Free> free = section.isMapping("pose") ? Optional.of(free(section)) : Optional.empty();
        return new Start(free.isEmpty() ? poses(section, count, what) : List.of(), free);
    }

    /// @param passage clearance of the ways between places [m]
    /// @param within empty for anywhere
    record Free(double clearance, double passage, Optional<Place.Rectangle> within) {
        /// Where there is room on a map.
        FreeSpace on(OccupancyGrid map, MapFacts facts) {
            return facts.freeSpace(map, clearance, passage);
        }

        /// A place that suits, at least twice the clearance from all others; empty when none was found.
        Optional<Pose2d> choose(FreeSpace space, long seed, Collection<Pose2d> others, Predicate<Pose2d> suits) {
            return space.choose(
                    new SplittableRandom(seed),
                    pose -> within.map(area -> area.holds(pose.position(), 0)).orElse(true)
                            && others.stream().noneMatch(other -> other.distanceTo(pose) < 2 * clearance)
                            && suits.test(pose));
        }
    }

    private static Free free(Section section) {
        Section pose = section.section("pose");
        if (!Boolean.TRUE.equals(pose.value(Format.FREE).orElse(true)) || !pose.has("free")) {
            pose.problem(
                    pose.location(),
                    "'%s' must be [x, y, degrees], a list of those, or {free: true}.".formatted(section.path("pose")),
                    "");
        }
        double clearance = (Double) pose.value(Format.CLEARANCE).orElse(0.4);
        double passage =
                pose.has("passage") ? (Double) pose.value(Format.PASSAGE).orElse(clearance) : clearance;
        if (passage > clearance) {
            pose.problem(
                    "passage", "'passage' must not be more than 'clearance', which is %s.".formatted(clearance), "");
        }
        Optional<Place.Rectangle> within = PlaceReader.rectangle(pose);
        pose.done();
        return new Free(clearance, passage, within);
    }

    private static List<Pose2d> poses(Section section, int count, String what) {
        Optional<Value> value = section.find("pose");
        if (value.isEmpty()) {
            return List.of();
        }
        if (!(value.get() instanceof Value.Sequence sequence)) {
            section.expected("pose", "[x, y, degrees], a list of those, or {free: true}", value.get());
            return List.of();
        }
        boolean several =
                !sequence.items().isEmpty() && sequence.items().stream().allMatch(Value.Sequence.class::isInstance);
        List<Value> written = several ? sequence.items() : List.of(sequence);
        var poses = written.stream()
                .flatMap(pose -> section.numbers("pose", pose, 3).stream())
                .map(n -> Pose2d.ofDegrees(n[0], n[1], n[2]))
                .toList();
        if (written.size() < count) {
            section.problem(
                    "pose",
                    "'%s' has %d for %d %s.".formatted(section.path("pose"), written.size(), count, what),
                    "Write a list of poses, or {free: true}.");
        }
        return poses.size() < count ? List.of() : poses.subList(0, count);
    }

    /// What those of a group are called: after it, with numbers from 1 on where they are counted.
    static List<String> names(String group, Section section) {
        if (!section.has("count")) {
            return List.of(group);
        }
        int count = Math.toIntExact((Long) section.value(Format.COUNT).orElse(1L));
        return IntStream.rangeClosed(1, count)
                .mapToObj(number -> group + "-" + number)
                .toList();
    }
}
