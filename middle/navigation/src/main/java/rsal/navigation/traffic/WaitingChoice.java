package rsal.navigation.traffic;

import org.jspecify.annotations.Nullable;
import rsal.data.Point2d;
import rsal.navigation.passage.Gate;
import rsal.navigation.traffic.Mates.Mate;
import rsal.navigation.traffic.TrafficReport.Claim;

/// Chooses where a robot waits at a gate: away from others that wait, and from where others leave the passage.
final class WaitingChoice {
    private static final double APART = 0.1; // m between bodies of who waits and who leaves

    private static final int CROWD = 2; // others that wait at a gate, from which on the way out is kept wider
    private static final double EXIT = 0.25; // m more between who waits in a crowd and who leaves
    private static final double BESIDE = 0.4; // m more beside the way out
    private static final double IN_EXIT = 6; // m that a place in the way out counts as farther

    private final Mates mates;
    private final String robot;
    private final double radius;

    /// @param robot own id
    /// @param radius of the circle that it turns in [m]
    WaitingChoice(Mates mates, String robot, double radius) {
        this.mates = mates;
        this.robot = robot;
        this.radius = radius;
    }

    /// The one that it has, if that is still free; null when there is none at that gate.
    ///
    /// @param position of the robot, in the map frame
    @Nullable
    Point2d choose(OwnClaim wanted, Gate gate, Point2d position) {
        double apart = 2 * radius + APART;
        boolean isCrowd = waiting(gate) >= CROWD;
        double exit = isCrowd ? EXIT : 0;
        Point2d kept = wanted.waiting;
        if (kept != null && gate.waitingPlaces().contains(kept) && room(kept, wanted, exit) >= 0.9 * apart) {
            return kept;
        }
        Point2d best = null;
        double bestRank = Double.POSITIVE_INFINITY;
        for (Point2d place : gate.waitingPlaces()) {
            double missing = Math.max(0, apart - room(place, wanted, exit));
            double inExit = isCrowd ? inExit(place, gate, apart + BESIDE) : 0;
            double rank =
                    position.distanceTo(place) + 1.5 * place.distanceTo(gate.mapFromGate()) + 20 * missing + inExit;
            if (rank < bestRank) {
                bestRank = rank;
                best = place;
            }
        }
        return best;
    }

    private static double inExit(Point2d place, Gate gate, double free) {
        double x = place.x() - gate.mapFromGate().x();
        double y = place.y() - gate.mapFromGate().y();
        double lateral = Math.abs(Math.cos(gate.heading()) * y - Math.sin(gate.heading()) * x);
        return IN_EXIT * Math.max(0, free - lateral) / free;
    }

    /// How many others wait at a gate, or come to it.
    private int waiting(Gate gate) {
        int count = 0;
        for (Mate mate : mates.all()) {
            boolean waits = mate.report
                    .claim()
                    .filter(other -> !other.isHeld() && GateNeighbors.isSame(other.entry(), gate.mapFromGate()))
                    .isPresent();
            count += waits ? 1 : 0;
        }
        return count;
    }

    /// Distance from a place to what it should be away from [m].
    ///
    /// @param exit how much farther it is to be from where others leave [m]
    private double room(Point2d place, OwnClaim wanted, double exit) {
        double least = Double.POSITIVE_INFINITY;
        for (Mate mate : mates.all()) {
            Claim other = mate.report.claim().orElse(null);
            if (other == null) {
                least = Math.min(
                        least, place.distanceTo(mate.report.mapFromBase().position()));
            } else if (!other.isHeld()) {
                if (other.waiting().isPresent() && wanted.isAfter(other, mate.robot, robot)) {
                    least = Math.min(least, place.distanceTo(other.waiting().get()));
                }
            } else {
                for (Point2d point : other.exit()) {
                    least = Math.min(least, place.distanceTo(point) - exit);
                }
            }
        }
        return least;
    }

    /// Of a place from the straight line between two others [m].
    static double distance(Point2d place, Point2d from, Point2d to) {
        double x = to.x() - from.x();
        double y = to.y() - from.y();
        double square = x * x + y * y;
        double share = square == 0 ? 0 : ((place.x() - from.x()) * x + (place.y() - from.y()) * y) / square;
        double near = Math.clamp(share, 0, 1);
        return place.distanceTo(new Point2d(from.x() + near * x, from.y() + near * y));
    }
}
