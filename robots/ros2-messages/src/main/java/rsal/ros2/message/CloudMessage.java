package rsal.ros2.message;

import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import rsal.data.ParticleCloud;
import rsal.data.Pose2d;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.cdr.RosMessage;

/// Particles of localizers as `nav2_msgs/ParticleCloud`.
public final class CloudMessage {
    private static final int MOST = 100_000; // particles; amcl of Nav2 has 2,000 at most unless it is set otherwise

    private CloudMessage() {}

    /// The particles, with weights that sum to 1; equal ones where all are 0. Empty when there are none or too many,
    /// or one has a value that is not finite or a weight below 0.
    public static Optional<ParticleCloud> of(RosMessage message) {
        List<RosMessage> particles = message.messages("particles");
        int count = particles.size();
        if (count == 0 || count > MOST) {
            return Optional.empty();
        }
        var poses = new float[3 * count];
        var weights = new double[count];
        for (int i = 0; i < count; i++) {
            RosMessage particle = particles.get(i);
            Pose2d pose = FrameTransform.of(particle.message("pose"), "position", "orientation")
                    .planar();
            weights[i] = particle.number("weight");
            if (!pose.isFinite() || !(weights[i] >= 0) || !Double.isFinite(weights[i])) {
                return Optional.empty();
            }
            poses[3 * i] = (float) pose.x();
            poses[3 * i + 1] = (float) pose.y();
            poses[3 * i + 2] = (float) pose.theta();
        }
        return Optional.of(new ParticleCloud(poses, shares(weights)));
    }

    private static float[] shares(double[] weights) {
        double sum = Arrays.stream(weights).sum();
        boolean isWeighted = sum > 0 && Double.isFinite(sum);
        var shares = new float[weights.length];
        for (int i = 0; i < shares.length; i++) {
            shares[i] = (float) (isWeighted ? weights[i] / sum : 1.0 / shares.length);
        }
        return shares;
    }

    /// Writes particles of a frame.
    public static CdrWriter write(CdrWriter to, Instant time, String frame, ParticleCloud cloud) {
        RosMessages.write(to, time).text(frame).int32(cloud.count());
        float[] poses = cloud.poses();
        for (int i = 0; i < cloud.count(); i++) {
            var pose = new Pose2d(poses[3 * i], poses[3 * i + 1], poses[3 * i + 2]);
            RosMessages.write(to, FrameTransform.of(pose)).float64(cloud.weights()[i]);
        }
        return to;
    }
}
