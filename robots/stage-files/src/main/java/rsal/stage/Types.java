package rsal.stage;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

/// What entities there are, and what became of those of older versions of Stage.
final class Types {
    static final String BLOCK = "block";
    static final String SENSOR = "sensor";
    static final String WINDOW = "window";

    static final Set<String> MODELS = Set.of(
            "model",
            "position",
            "ranger",
            "blobfinder",
            "fiducial",
            "gripper",
            "bumper",
            "actuator",
            "camera",
            "blinkenlight",
            "lightindicator");

    static final Set<String> ALL = union(MODELS, List.of(BLOCK, SENSOR, WINDOW));

    private static final String RANGER =
            "Write ranger ( sensor ( range [0 8] fov 180 samples 180 ) ), with the values that this one has.";
    private static final String MODEL = "Write model, with the properties that this one has.";

    /// Types that later versions of Stage dropped, with what to write instead. Without them a world is not what
    /// its author meant.
    static final Map<String, String> REPLACED = Map.of(
            "laser", RANGER,
            "sonar", RANGER,
            "map", MODEL,
            "bitmap", MODEL,
            "box", MODEL,
            "wall", MODEL,
            "puck", "Write model ( gripper_return 1 ), with the properties that this one has.",
            "wifi", "Nothing simulates radios; take it out if its robots can do without.");

    /// Types that later versions of Stage dropped, and that worlds do well without.
    static final Set<String> DISPENSABLE =
            Set.of("audio", "speech", "gps", "truth", "ptz", "power", "battery", "gui", "mcom", "broadcast");

    private Types() {}

    static Set<String> obsolete() {
        return union(REPLACED.keySet(), List.copyOf(DISPENSABLE));
    }

    private static Set<String> union(Set<String> a, List<String> b) {
        var all = new TreeSet<>(a);
        all.addAll(b);
        return Collections.unmodifiableSet(all);
    }
}
