package rsal.model;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import rsal.data.Pose2d;
import rsal.robot.RobotModel.Part;
import rsal.settings.Location;
import rsal.settings.Problems;
import rsal.settings.Section;
import rsal.settings.Suggestion;
import rsal.settings.Value;

/// Where a device may sit.
///
/// @param height above the floor [m]; empty on top of the body
/// @param on the actuator that it stands on; empty for the base
/// @param writtenAt where that was written, for messages
record Mount(Pose2d baseFromDevice, OptionalDouble height, Optional<String> on, Location writtenAt) {

    /// `NAME: [x, y, heading]`, `NAME: [x, y, heading, height]`, or `NAME: {actuator: NAME, pose: […]}`.
    static Map<String, Mount> all(Section section) {
        var mounts = new LinkedHashMap<String, Mount>();
        for (String device : section.names()) {
            if (section.find(device).filter(Value.Mapping.class::isInstance).isPresent()) {
                Section reported = section.section(device);
                String on = reported.text("actuator");
                read(reported, "pose", Optional.of(on).filter(name -> !name.isEmpty()), reported.locationOf("actuator"))
                        .ifPresent(mount -> mounts.put(device, mount));
                if (!reported.has("pose")) {
                    reported.problem(
                            reported.location(),
                            "'%s' is missing: where it stands.".formatted(reported.path("pose")),
                            "");
                }
                reported.done();
            } else {
                read(section, device, Optional.empty(), section.locationOf(device))
                        .ifPresent(mount -> mounts.put(device, mount));
            }
        }
        check(mounts, section);
        return mounts;
    }

    private static Optional<Mount> read(Section section, String key, Optional<String> on, Location writtenAt) {
        boolean high = section.find(key)
                .filter(value ->
                        value instanceof Value.Sequence place && place.items().size() == 4)
                .isPresent();
        return section.numbers(key, high ? 4 : 3).map(place -> {
            if (high && !(place[3] >= 0 && place[3] <= NumberReader.MOST)) {
                section.problem(
                        key,
                        "'%s' must be from 0 to %s high, not '%s'."
                                .formatted(section.path(key), NumberReader.MOST, place[3]),
                        "");
            }
            return new Mount(
                    Pose2d.ofDegrees(place[0], place[1], place[2]),
                    high ? OptionalDouble.of(place[3]) : OptionalDouble.empty(),
                    on,
                    writtenAt);
        });
    }

    private static void check(Map<String, Mount> mounts, Section section) {
        mounts.forEach((device, mount) -> {
            var passed = new HashSet<>(Set.of(device));
            Optional<String> on = mount.on;
            while (on.isPresent() && mounts.containsKey(on.get()) && passed.add(on.get())) {
                on = mounts.get(on.get()).on;
            }
            on.ifPresent(last -> section.problem(
                    mount.writtenAt,
                    mounts.containsKey(last)
                            ? "'%s' stands on what stands on '%s'.".formatted(device, last)
                            : "'%s' stands on '%s', which 'mounts' does not list.".formatted(device, last),
                    mounts.containsKey(last) ? "" : Suggestion.among(last, mounts.keySet())));
        });
    }

    /// The actuators that devices stand on, by device. What is to stand on one that is not there stands on what that
    /// would stand on.
    ///
    /// @param sensors that the robot has
    static Map<String, String> carriers(Map<String, Mount> mounts, Map<String, Part> sensors, Problems problems) {
        var carriers = new LinkedHashMap<String, String>();
        for (String device : sensors.keySet()) {
            Mount mount = mounts.get(device);
            if (mount == null) {
                continue; // it is nowhere, as what a computer does
            }
            Optional<String> on = mount.on;
            while (on.isPresent() && !sensors.containsKey(on.get())) {
                on = Objects.requireNonNull(mounts.get(on.get())).on;
            }
            on.ifPresent(carrier -> {
                if (sensors.get(carrier) instanceof Part.Actuator) {
                    carriers.put(device, carrier);
                } else {
                    problems.add(
                            mount.writtenAt,
                            "'%s' stands on '%s', which is not an actuator.".formatted(device, carrier),
                            "Only actuators carry devices.");
                }
            });
        }
        return carriers;
    }
}
