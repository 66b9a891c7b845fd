package rsal.agents.formation;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import rsal.data.Point2d;

/// How robots stand to each other in a formation: line, column and wedge as T. Balch and R. Arkin have them
/// (Behavior-Based Formation Control for Multirobot Teams, IEEE Transactions on Robotics and Automation 14, 1998);
/// their diamond is a wedge's and a grid's special case and left out, circle and grid are added.
public enum FormationShape {
    /// Side by side.
    LINE {
        @Override
        public Point2d place(int number, int robots, double spacing) {
            return new Point2d(0, (number - (robots - 1) / 2.0) * spacing);
        }
    },
    /// One after the other.
    COLUMN {
        @Override
        public Point2d place(int number, int robots, double spacing) {
            return new Point2d(-number * spacing, 0);
        }
    },
    /// A tip and two wings that trail at 45°.
    WEDGE {
        @Override
        public Point2d place(int number, int robots, double spacing) {
            int fromTip = (number + 1) / 2;
            double along = fromTip * spacing * Math.sqrt(0.5);
            return new Point2d(-along, number % 2 == 0 ? along : -along);
        }
    },
    /// Evenly on a circle, all looking ahead.
    CIRCLE {
        @Override
        public Point2d place(int number, int robots, double spacing) {
            double radius = robots < 2 ? 0 : spacing / (2 * Math.sin(Math.PI / robots));
            double angle = 2 * Math.PI * number / robots;
            return new Point2d(radius * Math.cos(angle), radius * Math.sin(angle));
        }
    },
    /// As many ranks as files, or one less; the last rank may have gaps at its ends.
    GRID {
        @Override
        public Point2d place(int number, int robots, double spacing) {
            int files = (int) Math.ceil(Math.sqrt(robots));
            int rank = number / files;
            int inRank = Math.min(files, robots - rank * files);
            return new Point2d(-rank * spacing, (number % files - (inRank - 1) / 2.0) * spacing);
        }
    };

    /// @param number of a robot, from 0
    /// @param spacing between neighbors [m]
    /// @return in the formation's frame, x ahead
    public abstract Point2d place(int number, int robots, double spacing);

    public List<Point2d> places(int robots, double spacing) {
        var places = new ArrayList<Point2d>();
        for (int i = 0; i < robots; i++) {
            places.add(place(i, robots, spacing));
        }
        return places;
    }

    /// As people write it.
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    public static List<String> words() {
        return Stream.of(values()).map(FormationShape::word).toList();
    }

    public static FormationShape of(String word) {
        return valueOf(word.toUpperCase(Locale.ROOT));
    }
}
