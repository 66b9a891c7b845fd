package rsal.stage;

import java.util.ArrayList;
import java.util.List;
import rsal.settings.Value;
import rsal.stage.Units.Kind;

/// What a tuple of numbers is made of.
///
/// @param shape how it is written, `[x y z a]`
/// @param meaning of its numbers, for people; `{length}` and `{angle}` stand for the units of the world
/// @param bounds of its lengths [m] and of its numbers that are neither lengths nor angles
/// @param parts one for each number
record Form(String shape, String meaning, ValueRange bounds, List<Part> parts) {
    /// Coordinates beyond are errors [m].
    static final double FARTHEST = 1e6;

    /// The least number that is positive.
    static final double ABOVE_0 = Double.MIN_VALUE;

    /// Numbers beyond are errors: lengths in m, angles in the unit that the world has.
    static final ValueRange ANY = new ValueRange(-1e9, 1e9);

    static final Form POSE = of(
            "[x y z a]",
            "x, y and z in {length}, and the heading in {angle}",
            new ValueRange(-FARTHEST, FARTHEST),
            length(0),
            length(0),
            length(0),
            angle(0));
    static final Form SIZE = of(
            "[x y z]",
            "length, width and height in {length}",
            new ValueRange(0, FARTHEST),
            length(0.4),
            length(0.4),
            length(1));
    static final Form VELOCITY = of(
            "[x y z a]",
            "forward, to the left and up in {length}/s, and turning in {angle}/s",
            ANY,
            length(0),
            length(0),
            length(0),
            angle(0));
    static final Form SPEEDS = limits("/s");
    static final Form ACCELERATIONS = limits("/s²");
    static final Form ODOMETRY_ERROR = of(
            "[x y z a]",
            "shares of the ways forward, to the left and up, and of turns",
            ANY,
            number(0),
            number(0),
            number(0),
            number(0));
    static final Form COLOR = of(
            "[r g b a]",
            "red, green, blue and opacity, each from 0 to 1",
            ANY,
            number(1),
            number(1),
            number(1),
            number(1));
    static final Form RANGE = of("[min max]", "the least and the greatest in {length}", ANY, length(0), length(5));
    static final Form POINT = of("[x y]", "to the right and up", ANY, number(0), number(0));
    static final Form NOISE = of(
            "[constant proportional angular]",
            "a variance, a share of the range, and a share of the angle between two rays",
            ANY,
            length(0),
            number(0),
            angle(0));
    static final Form PADDLES = of(
            "[x y z]",
            "shares of the gripper's length, width and height",
            new ValueRange(0, 1),
            number(0.66),
            number(0.1),
            number(0.4));
    static final Form AXIS = of("[x y z]", "forward, to the left and up", ANY, number(1), number(0), number(0));
    static final Form VIEW = of("[across up]", "both in {angle}", ANY, angle(70), angle(40));
    static final Form PAN_AND_TILT = of("[pan tilt]", "both in {angle}", ANY, angle(0), angle(0));

    Form {
        parts = List.copyOf(parts);
    }

    /// Columns and rows of an image.
    ///
    /// @param most of each
    static Form image(int most, int columns, int rows) {
        return of("[width height]", "columns and rows", new ValueRange(1, most), number(columns), number(rows));
    }

    private static Form limits(String per) {
        return of(
                "[xmin xmax ymin ymax zmin zmax amin amax]",
                "the least and the greatest forward, to the left and up in {length}" + per + ", and turning in {angle}"
                        + per,
                ANY,
                length(-1),
                length(1),
                length(-1),
                length(1),
                length(-1),
                length(1),
                angle(-90),
                angle(90));
    }

    /// @param usual what is proposed where it is missing, in m and degrees
    record Part(Kind kind, double usual) {}

    private static Form of(String shape, String meaning, ValueRange bounds, Part... parts) {
        return new Form(shape, meaning, bounds, List.of(parts));
    }

    private static Part length(double usual) {
        return new Part(Kind.LENGTH, usual);
    }

    private static Part angle(double usual) {
        return new Part(Kind.ANGLE, usual);
    }

    private static Part number(double usual) {
        return new Part(Kind.NUMBER, usual);
    }

    /// What may have been meant by a tuple that has too few numbers.
    String completion(List<Value> given, Units units) {
        var words = new ArrayList<String>();
        boolean numeric = given.stream().noneMatch(value -> Double.isNaN(Units.number(value)));
        if (numeric) {
            given.forEach(value -> words.add(Units.text(value)));
        }
        String how = words.isEmpty() ? "Write %s, say: %s." : "Maybe %s: %s.";
        if (equals(RANGE) && words.size() == 1) {
            words.addFirst("0");
        } else if (shape.equals("[x y z a]") && words.size() == 3) {
            words.add(2, "0"); // as in older worlds, which had no z
        }
        for (Part missing : parts.subList(words.size(), parts.size())) {
            words.add(units.written(missing.kind, missing.usual));
        }
        return how.formatted(
                "[" + String.join(" ", words) + "]",
                meaning.replace("{length}", units.name(Kind.LENGTH)).replace("{angle}", units.name(Kind.ANGLE)));
    }
}
