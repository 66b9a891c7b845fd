package rsal.ros2.device;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.ArrayList;
import java.util.List;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosLink.ServiceClient;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;
import rsal.ros2.setting.Safety;

/// Tells a robot itself that its motors are to be off, as after an emergency stop, so that it stands still whatever
/// others command: by a topic, by a service, or both.
final class MotorSwitch {
    private static final Logger LOG = System.getLogger(MotorSwitch.class.getName());
    private static final String BOOL = "std_msgs/msg/Bool";
    private static final String SET_BOOL = "std_srvs/srv/SetBool";

    private final List<Publication> publications = new ArrayList<>(); // one at most
    private final List<ServiceClient> services = new ArrayList<>(); // one at most
    private final String robot;

    /// @param namespace of the robot: `/robot1`
    MotorSwitch(String robot, RosLink link, String namespace, Safety safety) {
        this.robot = robot;
        if (!safety.stopTopic().isEmpty()) {
            publications.add(link.advertise(new RosTopic(namespace + "/" + safety.stopTopic(), BOOL), Profile.LATCHED));
        }
        if (!safety.stopService().isEmpty()) {
            services.add(link.client(namespace + "/" + safety.stopService(), SET_BOOL));
        }
    }

    /// @param enabled whether its motors may move it
    void publish(boolean enabled) {
        byte[] stopped = new CdrWriter().bool(!enabled).toBytes();
        publications.forEach(each -> each.publish(stopped));
        for (ServiceClient service : services) {
            service.call(stopped).exceptionally(error -> {
                LOG.log(
                        Level.WARNING,
                        () -> "Robot '%s' can't be stopped by its service: %s".formatted(robot, error.getMessage()));
                return new byte[0];
            });
        }
    }

    void close() {
        publications.forEach(Publication::close);
        services.forEach(ServiceClient::close);
    }
}
