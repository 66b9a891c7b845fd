package rsal.navigation.slam;

import java.util.List;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.PoseEstimate.Hypothesis;
import rsal.data.PoseEstimate.Quality;

/// How sure a mapper is of where the robot is, against what it mapped around there. That a long way may bend the
/// map, so that all of it is off where it began, is not in it: that is known only when a loop closes. That a blind
/// drive did so is told in a word ([#quality]), while the robot finds its way in what it mapped since.
///
/// @param wheels how they err
/// @param matched covariance of the last match, joined with what was known before; in the map's axes
/// @param ground how far what it was matched with is off what was mapped before the robot drove blindly
/// @param score of the last match, 0–1
/// @param meters driven since the last match
/// @param radians turned since
/// @param misses scans in a row since that saw something, but not what is on the map
/// @param seeing whether the last scan matched
/// @param strange whether the next will match with what was mapped since, blindly
public record Tracking(
        Slam.Wheels wheels,
        Covariance2d matched,
        Covariance2d ground,
        double score,
        double meters,
        double radians,
        int misses,
        boolean seeing,
        boolean strange) {
    private static final Covariance2d NONE = Covariance2d.ofDeviations(0, 0, 0);
    private static final double GOOD_METERS = 0.1; // deviations up to which a place is told apart
    private static final double GOOD_RADIANS = 0.1;
    private static final double POOR_METERS = 0.5; // from which nothing is known without a match
    private static final double POOR_RADIANS = 0.35;
    private static final int MOST_MISSES = 10; // of scans in a row

    /// Where the map begins.
    static Tracking start(Slam.Wheels wheels) {
        return new Tracking(wheels, NONE, NONE, 1, 0, 0, 0, true, false);
    }

    /// After the robot moved.
    ///
    /// @param motion as the wheels say
    public Tracking moved(Pose2d motion) {
        return new Tracking(
                wheels,
                matched,
                ground,
                score,
                meters + Math.hypot(motion.x(), motion.y()),
                radians + Math.abs(motion.theta()),
                misses,
                seeing,
                strange);
    }

    /// @param covariance of the match against its surroundings, in the map's axes
    /// @param step how wheels err between two scans at least
    Tracking matched(Covariance2d covariance, Covariance2d step, double score) {
        if (strange) {
            return new Tracking(wheels, covariance, whole(), score, 0, 0, 0, true, false);
        }
        Covariance2d before = matched.plus(driven()).plus(step);
        return new Tracking(wheels, Gauss.joined(before, covariance), ground, score, 0, 0, 0, true, false);
    }

    /// @param comparable whether there was something in the scan, and something to match it with
    Tracking missed(boolean comparable) {
        return new Tracking(
                wheels, matched, ground, score, meters, radians, misses + (comparable ? 1 : 0), false, strange);
    }

    /// After a scan that didn't match was put on the map, with which the next ones match.
    Tracking mappedBlindly() {
        return new Tracking(wheels, matched, ground, score, meters, radians, misses, seeing, true);
    }

    /// After the map was fitted to what was there before the robot drove blindly.
    Tracking closed() {
        return new Tracking(wheels, matched, NONE, score, meters, radians, misses, seeing, strange);
    }

    /// Grown as wheels err since the last match, which pull to one side, so that deviations grow with the way.
    private Covariance2d driven() {
        double heading = wheels.radiansPerRadian() * radians + wheels.radiansPerMeter() * meters;
        double place = wheels.metersPerMeter() * meters;
        double aside = heading * meters / 2;
        double was = meters * meters * matched.thetaTheta();
        double square = place * place + aside * aside + was;
        return new Covariance2d(square, 0, 0, square, 0, heading * heading);
    }

    /// Of x, y and heading, in the map's axes, against what was mapped around the robot.
    public Covariance2d covariance() {
        return matched.plus(driven());
    }

    /// The same against what was mapped before the robot drove blindly.
    private Covariance2d whole() {
        return covariance().plus(ground);
    }

    /// How likely the place is right, 0–1: the score of the last match, and ever less by what was driven blindly and
    /// seen since.
    public double confidence() {
        double off = whole().positionDeviation() / POOR_METERS;
        return score * Math.exp(-off * off - 2.0 * misses / MOST_MISSES);
    }

    /// [Quality#LOST] when scans don't match for long or the wheels alone led the robot too far,
    /// [Quality#AMBIGUOUS] when they match but not in all directions, or with what was mapped after a blind drive.
    public Quality quality() {
        double place = whole().positionDeviation();
        double heading = Math.sqrt(whole().thetaTheta());
        if (misses >= MOST_MISSES || (!seeing && (place > POOR_METERS || heading > POOR_RADIANS))) {
            return Quality.LOST;
        }
        return place > GOOD_METERS || heading > GOOD_RADIANS ? Quality.AMBIGUOUS : Quality.LOCALIZED;
    }

    public PoseEstimate at(Pose2d mapFromBase) {
        Covariance2d covariance = covariance();
        return new PoseEstimate(
                mapFromBase, covariance, List.of(new Hypothesis(1, mapFromBase, covariance)), confidence(), quality());
    }
}
