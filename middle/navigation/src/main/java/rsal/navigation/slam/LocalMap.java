package rsal.navigation.slam;

import java.util.List;
import java.util.stream.IntStream;
import rsal.data.Pose2d;
import rsal.navigation.scanmatch.Cloud;

/// What several scans hit, in the frame of one of them.
final class LocalMap {
    private LocalMap() {}

    /// @param first number of a frame; those below 0 are left out
    /// @param last the same; those that aren't there are left out
    static Cloud of(List<GraphNode> frames, List<Pose2d> poses, int first, int last, int seenFrom) {
        return of(
                frames, poses, IntStream.rangeClosed(Math.max(0, first), Math.min(frames.size() - 1, last)), seenFrom);
    }

    static Cloud of(List<GraphNode> frames, List<Pose2d> poses, IntStream numbers, int seenFrom) {
        Pose2d centerFromMap = poses.get(seenFrom).inverse();
        return Cloud.joined(numbers.mapToObj(i -> frames.get(i).cloud().movedBy(centerFromMap.compose(poses.get(i))))
                .toList());
    }
}
