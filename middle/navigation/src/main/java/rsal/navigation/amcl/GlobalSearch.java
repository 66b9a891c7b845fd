package rsal.navigation.amcl;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.PriorityQueue;
import rsal.data.Angles;
import rsal.data.Point2d;
import rsal.data.Pose2d;

/// Where on the whole map a scan could have been taken: tries poses on a grid against a blurred likelihood field,
/// climbs from the best ones in the sharp field, then checks by casting rays that no beam went through a wall.
///
/// A particle filter that starts from such places needs far fewer particles than one that starts from uniform
/// ones; the idea of drawing particles from the sensor is S. Lenser, M. Veloso, Sensor Resetting Localization for
/// Poorly Modelled Mobile Robots (ICRA 2000).
final class GlobalSearch {
    private static final double STEP = 0.3; // m
    private static final int HEADINGS = 36;
    private static final int COARSE_BEAMS = 32;
    private static final int CLIMBERS = 400;
    private static final double CLEARANCE = 0.15; // m; no robot stands closer to a wall

    /// @param score mean logarithm of the likelihood of a beam; 0 is a perfect match
    record Candidate(double score, Pose2d mapFromBase) {}

    private final LocalizationMap map;

    GlobalSearch(LocalizationMap map) {
        this.map = map;
    }

    /// The best places, best first, none of them near a better one.
    List<Candidate> candidates(Beams beams, int limit) {
        List<Candidate> found = coarse(thin(beams)).stream()
                .map(c -> climb(beams, c.mapFromBase()))
                .map(pose -> new Candidate(score(beams, pose), pose))
                .sorted(Comparator.comparingDouble(Candidate::score).reversed())
                .toList();
        var best = new ArrayList<Candidate>();
        for (Candidate candidate : found) {
            if (best.size() == limit) {
                break;
            }
            if (best.stream().noneMatch(b -> b.mapFromBase().isNear(candidate.mapFromBase(), STEP, 0.2))) {
                best.add(candidate);
            }
        }
        return best;
    }

    /// How well a scan fits a place, when walls hide what is behind them.
    double score(Beams beams, Pose2d mapFromBase) {
        double sum = 0;
        for (int i = 0; i < beams.count(); i++) {
            sum += switch (verdict(beams, i, mapFromBase)) {
                case HIT -> log(beams, i, mapFromBase);
                case SHORT -> map.walls.unlikely();
                case THROUGH -> 2 * map.walls.unlikely();
            };
        }
        return beams.count() == 0 ? map.walls.unlikely() : sum / beams.count();
    }

    /// What became of a beam.
    enum Verdict {
        /// It ended at a wall of the map.
        HIT,
        /// It ended before one.
        SHORT,
        /// It ended behind one.
        THROUGH
    }

    Verdict verdict(Beams beams, int beam, Pose2d mapFromBase) {
        Point2d from = mapFromBase.transform(new Point2d(beams.originX()[beam], beams.originY()[beam]));
        Point2d to = mapFromBase.transform(new Point2d(beams.x()[beam], beams.y()[beam]));
        double measured = from.distanceTo(to);
        double direction = Math.atan2(to.y() - from.y(), to.x() - from.x());
        if (map.toOccupied.castRay(from.x(), from.y(), direction, measured) < measured - 4 * map.deviation) {
            return Verdict.THROUGH;
        }
        return map.toOccupied.at(to.x(), to.y()) <= 3 * map.deviation ? Verdict.HIT : Verdict.SHORT;
    }

    private double log(Beams beams, int beam, Pose2d mapFromBase) {
        Point2d to = mapFromBase.transform(new Point2d(beams.x()[beam], beams.y()[beam]));
        return map.walls.log(to.x(), to.y());
    }

    private List<Candidate> coarse(Beams beams) {
        var best = new PriorityQueue<Candidate>(Comparator.comparingDouble(Candidate::score));
        double resolution = map.grid.resolution();
        int stride = Math.max(1, (int) Math.round(STEP / resolution));
        var turnedX = new float[beams.count()];
        var turnedY = new float[beams.count()];
        for (int heading = 0; heading < HEADINGS; heading++) {
            double theta = Angles.wrap(heading * 2 * Math.PI / HEADINGS);
            double cos = Math.cos(theta) / resolution;
            double sin = Math.sin(theta) / resolution;
            for (int i = 0; i < beams.count(); i++) {
                turnedX[i] = (float) (cos * beams.x()[i] - sin * beams.y()[i]);
                turnedY[i] = (float) (sin * beams.x()[i] + cos * beams.y()[i]);
            }
            for (int row = stride / 2; row < map.grid.height(); row += stride) {
                for (int column = stride / 2; column < map.grid.width(); column += stride) {
                    if (map.toNotFree.at(row * map.grid.width() + column) < CLEARANCE) {
                        continue;
                    }
                    double score = map.nearWalls.log(turnedX, turnedY, column + 0.5f, row + 0.5f);
                    if (best.size() < CLIMBERS || score > best.element().score()) {
                        best.add(new Candidate(score, new Pose2d(map.grid.x(column), map.grid.y(row), theta)));
                        if (best.size() > CLIMBERS) {
                            best.remove();
                        }
                    }
                }
            }
        }
        return List.copyOf(best);
    }

    /// Hill climbing with ever smaller steps.
    private Pose2d climb(Beams beams, Pose2d start) {
        Pose2d pose = start;
        double meters = STEP / 2;
        double radians = Math.PI / HEADINGS;
        for (int round = 0; round < 4; round++) {
            LikelihoodField field = round == 0 ? map.nearWalls : map.walls;
            double score = field.log(beams, pose.x(), pose.y(), pose.theta());
            boolean better = true;
            while (better) {
                better = false;
                for (int way = 0; way < 6; way++) {
                    double sign = way % 2 == 0 ? 1 : -1;
                    var tried = new Pose2d(
                            pose.x() + (way / 2 == 0 ? sign * meters : 0),
                            pose.y() + (way / 2 == 1 ? sign * meters : 0),
                            pose.theta() + (way / 2 == 2 ? sign * radians : 0));
                    double reached = field.log(beams, tried.x(), tried.y(), tried.theta());
                    if (reached > score && map.grid.isFree(tried.x(), tried.y())) {
                        pose = tried;
                        score = reached;
                        better = true;
                    }
                }
            }
            meters /= 2;
            radians /= 2;
        }
        return pose;
    }

    private static Beams thin(Beams beams) {
        int every = Math.max(1, Math.ceilDiv(beams.count(), COARSE_BEAMS));
        int count = Math.ceilDiv(beams.count(), every);
        var thin = new Beams(new float[count], new float[count], new float[count], new float[count]);
        for (int i = 0; i < count; i++) {
            thin.x()[i] = beams.x()[i * every];
            thin.y()[i] = beams.y()[i * every];
            thin.originX()[i] = beams.originX()[i * every];
            thin.originY()[i] = beams.originY()[i * every];
        }
        return thin;
    }
}
