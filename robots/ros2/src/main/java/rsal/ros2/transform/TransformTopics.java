package rsal.ros2.transform;

import java.util.HashMap;
import java.util.Map;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.link.Inbox;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosTopic;
import rsal.ros2.type.TypeLibrary;
import rsal.time.Scheduler;

/// The topics `tf` and `tf_static` of a network, each of which is heard and kept once, as many robots may share them.
public final class TransformTopics {
    public static final String TYPE = "tf2_msgs/msg/TFMessage";
    private static final int WAITING = 100; // messages, as in tf2

    private final RosLink link;
    private final Scheduler scheduler;
    private final Map<Pair, TransformFeed> feeds = new HashMap<>();

    private record Pair(String moving, String fixed) {}

    /// @param link which is closed after the last use of this
    public TransformTopics(RosLink link, Scheduler scheduler) {
        this.link = link;
        this.scheduler = scheduler;
    }

    /// @param moving `/robot1/tf`
    /// @param fixed `/robot1/tf_static`
    /// @param types of the robot's distribution
    public TransformFeed feed(String moving, String fixed, TypeLibrary types) {
        return feeds.computeIfAbsent(new Pair(moving, fixed), topics -> open(topics, types));
    }

    private TransformFeed open(Pair topics, TypeLibrary types) {
        var feed = new TransformFeed(scheduler);
        MessageCodec codec = MessageCodec.of(types.get(TYPE), types);
        link.subscribe(
                new RosTopic(topics.moving, TYPE),
                Profile.DEFAULT,
                new Inbox<>(WAITING, codec::read, scheduler, feed::add));
        link.subscribe(
                new RosTopic(topics.fixed, TYPE),
                Profile.LATCHED,
                new Inbox<>(WAITING, codec::read, scheduler, feed::addFixed));
        return feed;
    }
}
