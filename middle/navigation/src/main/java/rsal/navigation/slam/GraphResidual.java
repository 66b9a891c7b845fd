package rsal.navigation.slam;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import rsal.data.Pose2d;

/// How much a fitted graph bends what it was told of a robot's way, from each scan that was kept to the next. What
/// the wheels say may be far off where they slipped, and a scan says so; a step that is off all that was told of it
/// was bent by loops, and of these some are wrong, or the robot was carried where it saw nothing.
///
/// @param wheels the step that is farthest off what the wheels say
/// @param scans the same of what scans say
/// @param all the step that is farthest off all that was told of it, with what it is least off
/// @param steps of the way
/// @param blind of them, told by wheels alone
public record GraphResidual(Optional<Step> wheels, Optional<Step> scans, Optional<Step> all, int steps, int blind) {
    /// From so many deviations on a step is not what it was told. In maps from logs that are right (seven, with usual
    /// odometry and with twice its noise) none was off by more than 3.4.
    public static final double TOO_MUCH = 6;

    /// What was told of a step, and how far off it is.
    ///
    /// @param from number of a frame
    /// @param to number of the next
    /// @param deviations by which the step is off, as its source errs
    /// @param meters the same
    /// @param radians the same, not negative
    public record Step(int from, int to, double deviations, double meters, double radians) {
        private static final Comparator<Step> BY_DEVIATIONS = Comparator.comparingDouble(Step::deviations);

        static Step of(Relation reported, List<Pose2d> poses) {
            Pose2d from = poses.get(reported.from());
            Pose2d to = poses.get(reported.to());
            Pose2d off = reported.fromFromTo().inverse().compose(from.inverse().compose(to));
            return new Step(
                    reported.from(),
                    reported.to(),
                    Math.sqrt(PoseGraph.square(reported, from, to)),
                    Math.hypot(off.x(), off.y()),
                    Math.abs(off.theta()));
        }
    }

    /// The step that is too far off all that was told of it, if there is one.
    public Optional<Step> tooLarge() {
        return all.filter(step -> step.deviations() > TOO_MUCH);
    }

    static GraphResidual of(List<Relation> relations, List<Pose2d> poses) {
        List<List<Relation>> steps = List.copyOf(relations.stream()
                .filter(r -> r.source() != Relation.Source.LOOP)
                .collect(Collectors.groupingBy(Relation::to))
                .values());
        return new GraphResidual(
                worst(relations, Relation.Source.ODOMETRY, poses),
                worst(relations, Relation.Source.SCANS, poses),
                steps.stream()
                        .map(reported -> reported.stream()
                                .map(r -> Step.of(r, poses))
                                .min(Step.BY_DEVIATIONS)
                                .orElseThrow())
                        .max(Step.BY_DEVIATIONS),
                steps.size(),
                (int) steps.stream()
                        .filter(reported -> reported.stream().noneMatch(r -> r.source() == Relation.Source.SCANS))
                        .count());
    }

    private static Optional<Step> worst(List<Relation> relations, Relation.Source source, List<Pose2d> poses) {
        return relations.stream()
                .filter(r -> r.source() == source)
                .map(r -> Step.of(r, poses))
                .max(Step.BY_DEVIATIONS);
    }
}
