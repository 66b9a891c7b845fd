package rsal.world.yaml;

import java.util.List;
import rsal.model.BodyReader;
import rsal.scene.Touch;
import rsal.settings.Parameter;
import rsal.settings.Section;

/// What can be set in a world, and how large it can be.
final class Keys {
    static final int VERSION = 1;
    static final double FARTHEST = 1e6; // [m]
    static final int MAX_SAME = 10_000; // things or robots that one group makes

    /// Things, and what robots are made of.
    static final BodyReader BODIES = new BodyReader(new BodyReader.Limits(100_000, 2_000, FARTHEST, -FARTHEST, 0.25));
    static final double WALL_HEIGHT = 2; // [m]
    /// Walls.
    static final BodyReader WALLS = new BodyReader(new BodyReader.Limits(1, 10_000, FARTHEST, -FARTHEST, WALL_HEIGHT));

    static final Parameter<Double> STEP =
            Parameter.number("step", 0.1, 0.01, 0.2, "s", "Time between two states of the world.");
    static final Parameter<Double> END = Parameter.number("end", 0, 0, 1e9, "s", "How long a run of it takes.");
    static final Parameter<String> ON_COLLISION = Parameter.choice(
            "onCollision",
            Touch.STALL.word(),
            Touch.words(),
            "Whether robots that drive into something stop or slide along it.");
    static final Parameter<Integer> SEED = Parameter.integer(
            "seed", 0, Long.MIN_VALUE, Long.MAX_VALUE, "", "Seed of the field. Default: the seed of the run.");
    static final Parameter<Integer> COUNT = Parameter.integer("count", 1, 1, MAX_SAME, "", "How many there are.");

    static final Parameter<Boolean> OBSTACLE = Parameter.flag("obstacle", true, "Whether it is in the way.");
    static final Parameter<Double> REFLECTANCE = Parameter.number(
            "reflectance",
            1,
            -1e9,
            1e9,
            "",
            "Its brightness for range sensors. If it is negative, they see through it.");
    static final Parameter<Boolean> BLOB = Parameter.flag("blob", true, "Whether blob detectors report it.");
    static final Parameter<Integer> FIDUCIAL =
            Parameter.integer("fiducial", 0, Integer.MIN_VALUE, Integer.MAX_VALUE, "", "Its marker id; 0: no marker.");
    static final Parameter<Integer> KEY = Parameter.integer(
            "key",
            0,
            Integer.MIN_VALUE,
            Integer.MAX_VALUE,
            "",
            "Only fiducial detectors with this key see the marker.");
    static final Parameter<Boolean> GRIPPABLE = Parameter.flag("grippable", false, "Whether grippers can hold it.");
    static final List<Parameter<?>> SURFACE = List.of(OBSTACLE, REFLECTANCE, BLOB, FIDUCIAL, KEY, GRIPPABLE);

    static final Parameter<Boolean> MOVES =
            Parameter.flag("moves", false, "Whether it may be moved later, so that the map does not show it.");

    static final Parameter<Double> GIVING = Parameter.number(
            "givingPower", 0, 0, 1e9, "W", "Maximum power with which it charges each robot that touches it.");

    static final Parameter<Boolean> CLOSED =
            Parameter.flag("closed", false, "Whether the line goes on from its end to its beginning.");
    static final Parameter<Double> THICKNESS = Parameter.number(
            "thickness",
            0.1,
            0,
            1000,
            "m",
            "Of a line; 0: thin as a sheet. Of a shape: it is hollow, its border so thick.");
    static final Parameter<Double> THRESHOLD = Parameter.number(
            "threshold", 0.5, 0, 1, "", "How bright a solid pixel may be, from 0 (black) to 1 (white).");
    static final Parameter<Boolean> FENCED = Parameter.flag("fenced", false, "Whether no robot leaves the image.");

    static final Parameter<Double> DENSITY =
            Parameter.number("density", 0.1, 0, 1000, "1/m²", "How many per square meter.");
    static final Parameter<Double> GAP =
            Parameter.number("gap", 0.5, 0, 100, "m", "Between an obstacle and others, walls and things, at least.");
    static final Parameter<Double> ROBOT_GAP =
            Parameter.number("robotGap", 1, 0, 100, "m", "Between an obstacle and robots at their start, at least.");

    static final Parameter<Double> CLEARANCE =
            Parameter.number("clearance", 0.4, 0.05, 100, "m", "Free space around a place that is chosen.");

    private Keys() {}

    static boolean flag(Section section, Parameter<?> parameter) {
        return Boolean.TRUE.equals(section.value(parameter).orElse(false));
    }

    static double number(Section section, Parameter<?> parameter) {
        return section.value(parameter).map(value -> (Double) value).orElse(1.0);
    }

    static long whole(Section section, Parameter<?> parameter) {
        return section.value(parameter).map(value -> (Long) value).orElse(1L);
    }
}
