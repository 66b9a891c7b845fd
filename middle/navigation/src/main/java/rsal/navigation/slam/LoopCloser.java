package rsal.navigation.slam;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;
import rsal.navigation.scanmatch.Cloud;
import rsal.navigation.scanmatch.CorrelativeMatcher;
import rsal.navigation.scanmatch.CorrelativeMatcher.Window;
import rsal.navigation.scanmatch.LineMatcher;
import rsal.navigation.scanmatch.Match;

/// Knows places again. Where a robot may be, by how sure the graph is of it ([Uncertainty]), its last scans are
/// searched for in those taken there before. What is found counts when points lie on lines and few beams go
/// through walls, and, where the search went far, only when several scans on end agree on it: E. Olson,
/// Recognizing places using spectrally clustered local matches, Robotics and Autonomous Systems 57 (2009), of
/// which this keeps the idea that wrong places don't agree.
///
/// Differs from the paper in these points:
/// * Two loops agree or don't: they put the newer frames at the same place, within bounds ([#agreeing]). The paper
///   weighs how well each pair fits, and finds those that agree by the dominant eigenvector of the matrix of all pairs.
/// * Two that agree are enough. Whether a place is like no other near it, and larger than the robot's uncertainty
/// (local
///   uniqueness, global sufficiency) is not tested; what contradicts others later is refused ([Refused]).
/// * Scans are searched for by a [CorrelativeMatcher], then laid on by a [LineMatcher], with beams through walls as
///   evidence against.
final class LoopCloser {
    private static final double DETOUR = 8; // m; less than this way is no loop
    private static final double VIEW = 6; // m; who is so near sees the same
    private static final double SIGMAS = 3;
    private static final double FARTHEST = 10; // m; a search
    private static final double MOST_TURN = 0.6; // rad
    private static final double SURE = 1; // m; nearer than this one scan does
    private static final double KNOWN_PLACE = 0.1; // m; deviation of a match that is led by more than one wall
    private static final int MOST_RUNS = 3; // searched for each scan
    private static final int AROUND = 5; // frames to either side, searched in
    static final int RECENT = 4; // frames, searched for
    private static final int PENDING = 20; // frames for which what was found is kept
    private static final int AGREEING = 2;
    private static final double AGREE_METERS = 0.4;
    private static final double AGREE_RADIANS = 0.06;
    private static final CorrelativeMatcher.Settings SEARCH = new CorrelativeMatcher.Settings(0.1, 0.12, 6);
    private static final double THINNED = 0.2; // m
    private static final double TRUST = 0.15; // in where the robot should be; see Window
    private static final double LEAST_SCORE = 0.38;
    private static final double LEAST_EVIDENCE = 0.4;
    private static final double FLOOR_METERS = 0.02; // that a relation errs at least
    private static final double FLOOR_RADIANS = 0.004;

    private final List<GraphNode> frames;
    private final Uncertainty uncertainty = new Uncertainty();
    private final List<Relation> pending = new ArrayList<>();

    LoopCloser(List<GraphNode> frames) {
        this.frames = frames;
    }

    /// Learns how one frame follows on another.
    void step(int from, int to, Pose2d fromFromTo, Covariance2d c) {
        double place = FLOOR_METERS * FLOOR_METERS;
        uncertainty.add(
                from,
                to,
                fromFromTo,
                new Covariance2d(
                        c.xx() + place,
                        c.xy(),
                        c.xTheta(),
                        c.yy() + place,
                        c.yTheta(),
                        c.thetaTheta() + FLOOR_RADIANS * FLOOR_RADIANS));
    }

    /// What closes loops now that a frame is there.
    List<Relation> look(int frame, List<Pose2d> poses) {
        pending.removeIf(r -> r.to() < frame - PENDING);
        double[][] deviations = uncertainty.from(frame, frames.size());
        List<Integer> candidates = candidates(frame, poses, deviations);
        var closing = new ArrayList<Relation>();
        for (int candidate : candidates) {
            double meters = Math.clamp(SIGMAS * deviations[candidate][0], 0.3, FARTHEST);
            double radians = Math.clamp(SIGMAS * deviations[candidate][1], 0.1, MOST_TURN);
            Optional<Relation> found = search(frame, candidate, poses, meters, radians);
            if (meters <= SURE) {
                found.filter(loop -> isSound(loop, poses)).ifPresent(closing::add);
            } else {
                found.ifPresent(pending::add);
            }
        }
        closing.addAll(agreed(poses));
        return closing;
    }

    /// Not when it contradicts the graph by walls alone along which the robot may be anywhere: these look like others.
    static boolean isSound(Relation loop, List<Pose2d> poses) {
        return loop.covariance().positionDeviation() <= KNOWN_PLACE
                || PoseGraph.square(loop, poses.get(loop.from()), poses.get(loop.to())) <= PoseGraph.LOOP_PHI;
    }

    /// Learns that a loop was right.
    void trust(Relation loop) {
        step(loop.from(), loop.to(), loop.fromFromTo(), loop.covariance());
    }

    /// Learns that it was wrong after all.
    void distrust(Relation loop) {
        uncertainty.remove(loop.from(), loop.to());
    }

    /// The nearest frame of each run of frames in a row near which the robot may be, nearest first.
    private List<Integer> candidates(int frame, List<Pose2d> poses, double[][] deviations) {
        record Near(int frame, double distance) {}
        var nearest = new ArrayList<Near>();
        int lastNear = -10;
        for (int other = 0; other < frame; other++) {
            double way = frames.get(frame).traveled() - frames.get(other).traveled();
            double distance = poses.get(frame).distanceTo(poses.get(other));
            double reach = VIEW + Math.min(FARTHEST, SIGMAS * deviations[other][0]);
            if (way < DETOUR || distance > reach) {
                continue;
            }
            var near = new Near(other, distance / (1 + deviations[other][0]));
            if (other - lastNear > AROUND) {
                nearest.add(near);
            } else if (near.distance < nearest.getLast().distance) {
                nearest.set(nearest.size() - 1, near);
            }
            lastNear = other;
        }
        return nearest.stream()
                .sorted(Comparator.comparingDouble(Near::distance).thenComparingInt(Near::frame))
                .limit(MOST_RUNS)
                .map(Near::frame)
                .toList();
    }

    private Optional<Relation> search(int frame, int candidate, List<Pose2d> poses, double meters, double radians) {
        Cloud there = LocalMap.of(frames, poses, candidate - AROUND, candidate + AROUND, candidate);
        Cloud here = LocalMap.of(frames, poses, frame - RECENT + 1, frame, frame);
        if (there.count() == 0 || here.count() == 0) {
            return Optional.empty();
        }
        Pose2d guess = poses.get(candidate).inverse().compose(poses.get(frame));
        return new CorrelativeMatcher(there, SEARCH)
                .match(here.thinned(THINNED), guess, new Window(meters, radians, TRUST), LEAST_SCORE)
                .flatMap(coarse -> refined(frame, candidate, there, here, coarse.aFromB(), 0.4));
    }

    private Optional<Relation> refined(
            int frame, int candidate, Cloud there, Cloud here, Pose2d guess, double farthest) {
        return new LineMatcher(there)
                .match(here, guess, farthest)
                .filter(m -> m.score() >= LEAST_EVIDENCE && m.aFromB().isNear(guess, 0.5, 0.2))
                .filter(m -> evidence(m, frame, candidate, there, here) >= LEAST_EVIDENCE)
                .map(m ->
                        new Relation(candidate, frame, m.aFromB(), Slam.honest(m.covariance()), Relation.Source.LOOP));
    }

    /// Share of the points that lie where points are, less half of that of the beams, of either scan, which
    /// go through what the others hit.
    private double evidence(Match match, int frame, int candidate, Cloud there, Cloud here) {
        Pose2d hereFromThere = match.aFromB().inverse();
        double through = new Transparency(there).through(frames.get(frame), match.aFromB())
                + new Transparency(here).through(frames.get(candidate), hereFromThere);
        return match.score() - through / 2;
    }

    /// Those found far away that agree on where the robot really is.
    private List<Relation> agreed(List<Pose2d> poses) {
        for (Relation one : pending) {
            List<Relation> agreeing = agreeing(one, pending, poses, AGREE_METERS, AGREE_RADIANS);
            if (agreeing.stream().map(Relation::to).distinct().count() >= AGREEING) {
                pending.removeAll(agreeing);
                return agreeing;
            }
        }
        return List.of();
    }

    /// Those loops that put the newer frame of one where that one does.
    ///
    /// @param meters how far off that may be
    /// @param radians the same
    static List<Relation> agreeing(
            Relation one, List<Relation> loops, List<Pose2d> poses, double meters, double radians) {
        Pose2d place = poses.get(one.to());
        Pose2d corrected = correction(one, poses).compose(place);
        return loops.stream()
                .filter(loop -> correction(loop, poses).compose(place).isNear(corrected, meters, radians))
                .toList();
    }

    /// Where the map's frame should be for the newer part of the map.
    private static Pose2d correction(Relation relation, List<Pose2d> poses) {
        return poses.get(relation.from())
                .compose(relation.fromFromTo())
                .compose(poses.get(relation.to()).inverse());
    }

    /// All that lies near each other in a map that is nearly right.
    List<Relation> everywhere(List<Pose2d> poses) {
        var found = new ArrayList<Relation>();
        for (int frame = 1; frame < frames.size(); frame++) {
            var none = new double[frames.size()][2];
            for (int candidate : candidates(frame, poses, none)) {
                Cloud there = LocalMap.of(frames, poses, candidate - AROUND, candidate + AROUND, candidate);
                Pose2d guess = poses.get(candidate).inverse().compose(poses.get(frame));
                if (there.count() > 0) {
                    refined(frame, candidate, there, frames.get(frame).cloud(), guess, 0.3)
                            .ifPresent(found::add);
                }
            }
        }
        return found;
    }
}
