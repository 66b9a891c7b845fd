package rsal.navigation.slam;

import java.util.ArrayList;
import java.util.List;
import rsal.data.Pose2d;
import rsal.navigation.scanmatch.Cloud;

/// What several scans in a row hit, in the frame of one of them.
final class Surroundings {
    private Surroundings() {}

    /// @param first number of a frame; those below 0 are left out
    /// @param last likewise; those that aren't there are left out
    static Cloud of(List<Frame> frames, List<Pose2d> poses, int first, int last, int seenFrom) {
        Pose2d centerFromMap = poses.get(seenFrom).inverse();
        var clouds = new ArrayList<Cloud>();
        for (int i = Math.max(0, first); i <= Math.min(frames.size() - 1, last); i++) {
            clouds.add(frames.get(i).cloud().movedBy(centerFromMap.compose(poses.get(i))));
        }
        return Cloud.joined(clouds);
    }
}
