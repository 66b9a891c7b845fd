package rsal.agents.swarm;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import rsal.agents.formation.FormationShape;
import rsal.agents.formation.FormationSlots;
import rsal.data.Angles;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// A formation without a leader: each robot moves toward the mean of the centers that its own and its neighbors' poses
/// imply, and all drive along the same route. When robots fail, the others close the gap.
///
/// Source: R. Olfati-Saber, J. A. Fax and R. M. Murray, "Consensus and cooperation in networked multi-agent systems"
/// (Proceedings of the IEEE 95, 2007): x' = Σ ((x_j − d_j) − (x_i − d_i)) + v, with the offsets d of the shape.
///
/// Departures: the common velocity falls with the largest error that a robot knows of, so that the team waits for one
/// that lags. The robot at a place is given by the order of ids, so all must hear each other.
public final class ConsensusFormation implements SwarmRuleType {
    static final Parameter<String> SHAPE =
            Parameter.choice("shape", FormationShape.WEDGE.word(), FormationShape.words(), "Shape of the formation.");
    static final Parameter<Double> SPACING =
            Parameter.number("spacing", 1.5, 0.6, 20, "m", "Distance of neighbors in the formation.");
    static final Parameter<List<Point2d>> ROUTE =
            Parameter.places("route", "Places to which the formation drives, one after the other. Default: it stands.");

    private static final double CRUISE = 0.7; // share of the speed, so that one that lags can catch up
    private static final double GAIN = 0.8; // 1/s
    private static final double STANDS = 1.5; // m, error of one for which the others wait
    private static final double FORMED = 0.5; // m
    private static final double REACHED = 0.5; // m
    private static final double TURN_RATE = 0.15; // rad/s
    private static final double STILL = 0.05; // m; not worth a correction
    private static final Duration AHEAD = Duration.ofSeconds(1);

    @Override
    public String key() {
        return "formation";
    }

    @Override
    public String description() {
        return "The robots keep a formation by consensus, without a leader.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(SHAPE, SPACING, ROUTE);
    }

    @Override
    public SwarmRule create(Arguments arguments) {
        return new Keeping(FormationShape.of(arguments.get(SHAPE)), arguments.get(SPACING), arguments.get(ROUTE));
    }

    private static final class Keeping implements SwarmRule {
        private final FormationShape shape;
        private final double spacing;
        private final List<Point2d> mapFromRoute;
        private int next; // of the route
        private double heading; // of the formation, in the map frame
        private double before; // s
        private boolean formed;
        private int team;
        private @Nullable FormationSlots slots;

        Keeping(FormationShape shape, double spacing, List<Point2d> mapFromRoute) {
            this.shape = shape;
            this.spacing = spacing;
            this.mapFromRoute = mapFromRoute;
        }

        @Override
        public Point2d velocity(SwarmView view) {
            var poses = new TreeMap<String, Pose2d>();
            view.neighbors().forEach(neighbor -> poses.put(neighbor.robot(), neighbor.mapFromBase()));
            poses.put(view.robot(), view.mapFromBase());
            if (poses.size() != team) {
                team = poses.size();
                formed = false;
            }
            if (!formed && next < mapFromRoute.size()) { // about the same for all that hear each other
                Point2d middle =
                        mean(poses.values().stream().map(Pose2d::position).toList());
                heading = Vectors.angle(Vectors.sum(mapFromRoute.get(next), -1, middle));
            }
            List<Point2d> offsets = offsets(poses.size());
            var centers = new ArrayList<Point2d>();
            int number = 0;
            int own = 0;
            for (Map.Entry<String, Pose2d> one : poses.entrySet()) {
                own = one.getKey().equals(view.robot()) ? number : own;
                centers.add(Vectors.sum(one.getValue().position(), -1, offsets.get(number++)));
            }
            Point2d center = mean(centers);
            double worst =
                    centers.stream().mapToDouble(center::distanceTo).max().orElse(0);
            formed |= worst <= FORMED;
            Point2d common = common(view, center, worst);
            Point2d error = Vectors.sum(center, -1, centers.get(own));
            note(view, Vectors.sum(center, 1, offsets.get(own)), common);
            boolean still = Vectors.length(error) < STILL && common.equals(STAND);
            return still ? STAND : Vectors.sum(common, GAIN, error);
        }

        /// From the center of the formation to each place, in the map frame.
        private List<Point2d> offsets(int robots) {
            List<Point2d> places = shape.places(robots, spacing);
            Point2d middle = mean(places);
            Pose2d turned = new Pose2d(0, 0, heading);
            return places.stream()
                    .map(place -> turned.transform(Vectors.sum(place, -1, middle)))
                    .toList();
        }

        private static Point2d mean(List<Point2d> points) {
            Point2d sum = STAND;
            for (Point2d point : points) {
                sum = Vectors.sum(sum, 1, point);
            }
            return new Point2d(sum.x() / points.size(), sum.y() / points.size());
        }

        /// The velocity that all have: along the route, and slower while one lags.
        private Point2d common(SwarmView view, Point2d center, double worst) {
            double passed = view.time() - before;
            before = view.time();
            while (next < mapFromRoute.size() && center.distanceTo(mapFromRoute.get(next)) < REACHED) {
                next++;
            }
            if (next == mapFromRoute.size() || !formed) {
                return STAND;
            }
            Point2d to = Vectors.sum(mapFromRoute.get(next), -1, center);
            double turn = Angles.wrap(Vectors.angle(to) - heading);
            double most = TURN_RATE * passed;
            heading = Angles.wrap(heading + Math.clamp(turn, -most, most));
            double speed = CRUISE * view.speed() * Math.max(0, 1 - worst / STANDS);
            return Vectors.withLength(to, speed);
        }

        private void note(SwarmView view, Point2d mapFromSlot, Point2d common) {
            var now = new Pose2d(mapFromSlot.x(), mapFromSlot.y(), heading);
            var later = new Pose2d(now.x() + common.x(), now.y() + common.y(), heading);
            slots = new FormationSlots(
                    shape.word(),
                    formed,
                    AHEAD,
                    new TreeMap<>(Map.of(view.robot(), new FormationSlots.Slot(now, later))));
        }

        @Override
        public Optional<FormationSlots> slots() {
            return Optional.ofNullable(slots);
        }
    }
}
