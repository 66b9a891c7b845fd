package rsal.environment;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import org.jspecify.annotations.Nullable;
import rsal.data.Fiducials;
import rsal.data.Fiducials.Fiducial;
import rsal.data.Pose2d;
import rsal.device.FiducialFinder;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Where the nearest markers are that the robot's fiducial detector sees, the nearest first. Walls hide them, and real
/// robots have it.
public final class MarkersObservation implements ObservationType {
    private static final int MOST = 1_000_000;
    private static final Parameter<Integer> FIRST =
            Parameter.integer("first", 0, 0, MOST, "", "The least id of the markers that count.");
    private static final Parameter<Integer> LAST =
            Parameter.integer("last", MOST, 0, MOST, "", "The greatest id of the markers that count.");
    private static final Parameter<Integer> COUNT = Parameter.integer("count", 1, 1, 100, "", "Number of markers.");
    private static final Parameter<Double> VISITED = Parameter.number(
            "visited",
            0,
            0,
            100,
            "m",
            "A marker does not count any more once it has been nearer than this; 0 for all that are seen.");
    private static final Parameter<Double> HOME = Parameter.number(
            "home",
            0,
            0,
            100,
            "m",
            "Markers within this distance of the robot's start do not count, by its localizer; 0 for all.");
    private static final Parameter<Double> MAX =
            Parameter.number("max", 10, 0.1, 1000, "m", "Greatest coordinate; those beyond count as this one.");

    @Override
    public String key() {
        return "markers";
    }

    @Override
    public String description() {
        return "Positions of the nearest markers that a fiducial detector sees, in the base frame [m].";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(FIRST, LAST, COUNT, VISITED, HOME, MAX);
    }

    @Override
    public LearnerObservation create(Arguments arguments) {
        return new Markers(
                arguments.get(FIRST),
                arguments.get(LAST),
                arguments.get(COUNT),
                arguments.get(VISITED),
                arguments.get(HOME),
                arguments.get(MAX).floatValue());
    }

    private record Markers(int first, int last, int count, double visited, double home, float max)
            implements LearnerObservation {
        @Override
        public List<String> fields() {
            var fields = new ArrayList<String>();
            for (int i = 1; i <= count; i++) {
                fields.add("x of marker %d [m]".formatted(i));
                fields.add("y of marker %d [m]".formatted(i));
                fields.add("marker %d is seen".formatted(i));
            }
            return fields;
        }

        @Override
        public float[] low() {
            return Bounds.repeated(count, -max, -max, 0);
        }

        @Override
        public float[] high() {
            return Bounds.repeated(count, max, max, 1);
        }

        @Override
        public Reader of(Robot robot, Truth world) {
            FiducialFinder finder = robot.find(FiducialFinder.class)
                    .orElseThrow(() -> new IllegalArgumentException(
                            "Robot '%s' has no fiducial detector for the observation 'markers'. Maybe 'fiducials: fiducials360'?"
                                    .formatted(robot.id())));
            OwnStart start = home > 0 ? new OwnStart(OwnPose.localizer(robot, "markers")) : null;
            return new Seen(this, finder, start);
        }
    }

    /// What one robot sees, and which markers it has been at.
    private static final class Seen implements LearnerObservation.Reader {
        private static final int EACH = 3; // x, y, whether it is seen

        private final Markers wanted;
        private final FiducialFinder finder;
        private final @Nullable OwnStart start;
        private final BitSet visited = new BitSet(); // ids, from the first one

        Seen(Markers wanted, FiducialFinder finder, @Nullable OwnStart start) {
            this.wanted = wanted;
            this.finder = finder;
            this.start = start;
        }

        @Override
        public void read(float[] to, int at) {
            Arrays.fill(to, at, at + EACH * wanted.count, 0);
            Pose2d startFromBase = start == null ? Pose2d.ORIGIN : start.startFromBase();
            List<Fiducial> seen = finder.latest()
                    .map(newest -> newest.value())
                    .map(Fiducials::fiducials)
                    .orElse(List.of());
            int found = 0;
            for (Fiducial each : seen) {
                int id = each.id().orElse(-1);
                if (id < wanted.first || id > wanted.last) {
                    continue;
                }
                double x = each.baseFromFiducial().x();
                double y = each.baseFromFiducial().y();
                if (Math.hypot(x, y) < wanted.visited) {
                    visited.set(id - wanted.first);
                }
                if (found == wanted.count || visited.get(id - wanted.first) || isAtHome(startFromBase, each)) {
                    continue;
                }
                int next = at + EACH * found;
                Bounds.put(x, y, wanted.max, to, next);
                to[next + 2] = 1;
                found++;
            }
        }

        private boolean isAtHome(Pose2d startFromBase, Fiducial marker) {
            return wanted.home > 0
                    && startFromBase
                                    .transform(marker.baseFromFiducial().position())
                                    .distanceTo(Pose2d.ORIGIN.position())
                            < wanted.home;
        }
    }
}
