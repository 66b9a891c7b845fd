package rsal.ros2.bridge;

import java.util.ArrayList;
import java.util.List;
import rsal.data.BumperState;
import rsal.data.Stamped;
import rsal.device.Bumper;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosPublisher.Publication;

/// Bumpers as `std_msgs/Bool`, each on a topic of its own, when it changes.
final class BumperPublication {
    private final CdrWriter writer = new CdrWriter();
    private final Bumper bumper;
    private final RobotOutlet outlet;
    private final List<Publication> topics = new ArrayList<>(); // one for each, once it is known how many there are
    private final List<Boolean> reported = new ArrayList<>();

    private BumperPublication(Bumper bumper, RobotOutlet outlet) {
        this.bumper = bumper;
        this.outlet = outlet;
    }

    static void begin(Bumper bumper, RobotOutlet outlet) {
        outlet.keep(bumper.subscribe(new BumperPublication(bumper, outlet)::publish));
    }

    private void publish(Stamped<BumperState> reading) {
        List<Boolean> pressed = reading.value().pressed();
        for (int i = 0; i < pressed.size(); i++) {
            boolean isNew = i == topics.size();
            if (isNew) {
                String name = "%s_%d".formatted(bumper.info().name(), i);
                topics.add(outlet.advertise(bumper, name, "std_msgs/msg/Bool", Profile.LATCHED));
                reported.add(false);
            }
            if (isNew || !reported.get(i).equals(pressed.get(i))) {
                reported.set(i, pressed.get(i));
                topics.get(i).publish(writer.clear().bool(pressed.get(i)).toBytes());
            }
        }
    }
}
