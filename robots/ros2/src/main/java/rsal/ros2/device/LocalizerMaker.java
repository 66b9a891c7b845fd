package rsal.ros2.device;

import rsal.device.DeviceInfo;
import rsal.device.Localizer;
import rsal.robot.RobotModel.Part;
import rsal.ros2.device.RosParts.Wanted;
import rsal.ros2.health.ReportNames;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink.Subscribed;
import rsal.ros2.link.RosTopic;
import rsal.ros2.setting.RosSettings;

/// Makes a localizer of `amcl_pose` or of the first topic of its type, or of TF alone; with the particles of
/// `particle_cloud`.
final class LocalizerMaker implements RosParts.Maker {
    private static final String POSE = "geometry_msgs/msg/PoseWithCovarianceStamped";
    private static final String CLOUD = "nav2_msgs/msg/ParticleCloud";

    @Override
    public boolean makes(Part part) {
        return RosParts.isOwn(part, Localizer.class);
    }

    @Override
    public ReportNames reportNames() {
        return ReportNames.of("amcl", "localization").needing("amcl", "slam_toolbox");
    }

    /// Its topics may come later, and TF is of all robots.
    @Override
    public boolean isThere(Wanted wanted, RobotTopics topics, RosSettings settings) {
        return true;
    }

    @Override
    public RosDevice make(DeviceInfo info, Wanted wanted, RosContext context) {
        RobotTopics topics = context.topics();
        RosTopic topic = topics.published(POSE, "amcl_pose").stream()
                .findFirst()
                .orElseGet(() -> new RosTopic(topics.namespace() + "/amcl_pose", POSE));
        var initial =
                context.link().advertise(new RosTopic(topics.namespace() + "/initialpose", POSE), Profile.DEFAULT);
        var cloud = new RosTopic(topics.namespace() + "/particle_cloud", CLOUD);
        var localizer = new RosLocalizer(
                info,
                topic.name(),
                initial,
                receiver -> context.newest(cloud, receiver),
                context.frames(),
                context.clock());
        context.base().onOdometry(localizer::take);
        Subscribed poses =
                context.link().subscribe(topic, topics.reliable(topic), context.inbox(POSE, 1, localizer::take));
        return new RosDevice(localizer, now -> localizer.look(now, poses.publishers()), () -> {
            poses.close();
            localizer.end();
        });
    }
}
