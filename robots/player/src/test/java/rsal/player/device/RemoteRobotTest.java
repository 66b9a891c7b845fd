package rsal.player.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.data.Pose2d;
import rsal.model.RobotModels;
import rsal.player.message.Interface;
import rsal.player.message.Session;
import rsal.player.wire.Address;
import rsal.player.wire.Packet;
import rsal.robot.RobotModel;
import rsal.robot.RobotSpec;
import rsal.settings.FileSource;
import rsal.settings.Location;
import rsal.testkit.contract.RobotBench;

/// Robots of different models behind one port: each has the devices that the others leave it.
@Timeout(60)
class RemoteRobotTest extends ScriptedBench {
    private static final RobotModel LOOKS = model(Map.of("laser", "urg04lx"));
    private static final RobotModel GRIPS = model(Map.of("laser", "none", "gripper", "pioneer-gripper"));
    private static final RobotModel BOTH = model(Map.of("laser", "urg04lx", "gripper", "pioneer-gripper"));

    RemoteRobotTest() {
        super(
                of(Interface.POSITION2D, 0),
                of(Interface.POSITION2D, 1),
                of(Interface.POSITION2D, 2),
                of(Interface.LASER, 0),
                of(Interface.LASER, 1),
                of(Interface.SONAR, 0),
                of(Interface.SONAR, 1),
                of(Interface.SONAR, 2),
                of(Interface.GRIPPER, 0),
                of(Interface.GRIPPER, 1),
                of(Interface.ACTARRAY, 0),
                of(Interface.ACTARRAY, 1));
    }

    private static Address of(Interface interf, int index) {
        return Address.of(interf.code(), index);
    }

    private static RobotModel model(Map<String, String> parts) {
        Location here = Location.of("test");
        var choices = new LinkedHashMap<String, RobotModels.Choice>();
        parts.forEach((device, part) -> choices.put(device, new RobotModels.Choice(part, here)));
        return new RobotModels(FileSource.resources(RobotBench.class, "/")).read("pioneer2dx", here, choices);
    }

    @Test
    void eachHasWhatThoseBeforeItLeave() throws IOException {
        meet(IDENT);
        awaitKnown();
        run(() -> robot("r3", BOTH, List.of(LOOKS, GRIPS)));
        assertThat(subscribed(5))
                .containsExactly(
                        Map.entry("actarray", 1),
                        Map.entry("gripper", 1),
                        Map.entry("laser", 1),
                        Map.entry("position2d", 2),
                        Map.entry("sonar", 2));
    }

    private void robot(String id, RobotModel model, List<RobotModel> before) {
        var spec = new RobotSpec(id, "tested", model, Optional.of(Pose2d.ORIGIN), "#3366cc");
        try {
            new RemoteRobot(spec, List.of(remote), before, Duration.ofMillis(500), false, time);
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    private Map<String, Integer> subscribed(int devices) throws IOException {
        var all = new TreeMap<String, Integer>();
        while (all.size() < devices) {
            Packet asked = client.next(Session.SERVER, Session.DEVICE);
            Address device = asked.body(Session.Subscription.class).device();
            all.put(Interface.words(device).split(":", 2)[0], device.index());
        }
        return all;
    }
}
