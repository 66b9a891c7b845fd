package rsal.python;

import java.util.HashMap;
import java.util.Map;
import rsal.agent.AgentContext;
import rsal.behavior.Pilot;
import rsal.behavior.PioneerStack;
import rsal.behavior.Repertoire;
import rsal.behavior.Subsumption;
import rsal.data.Twist2d;
import rsal.device.Device;
import rsal.python.PythonRequests.Heard;
import rsal.robot.Robot;
import rsal.settings.Suggestion;

/// The behaviors by which an agent in Python drives its robot: those that RSAL has, by name, and its own, under the
/// layers that keep the robot off obstacles. On the agent's lane.
final class PythonPilots {
    private final AgentContext self;
    private final Heard heard;
    private final Map<Integer, PythonBehavior> own = new HashMap<>(); // by number
    private boolean engaged;

    PythonPilots(AgentContext self, Heard heard) {
        this.self = self;
        this.heard = heard;
    }

    void perform(PythonRequests.Request asked, Robot robot) {
        if (asked.verb().equals("velocity")) {
            PythonBehavior behavior = own.get(asked.number(0));
            if (behavior != null) { // else another one drives by now
                behavior.answer((Twist2d) FromWords.value(asked.argument(1), Twist2d.class));
            }
            return;
        }
        Device device = robot.devices().get(asked.number(1));
        if (!(device instanceof Pilot pilot)) {
            throw new IllegalArgumentException(
                    "Device '%s' is no pilot.".formatted(device.info().id()));
        }
        int number = asked.number(0);
        String name = asked.text(2);
        own.clear();
        pilot.engage(number == 0 ? known(name, robot) : written(number, name, robot));
        if (!engaged) {
            engaged = true;
            self.atEnd(pilot::release);
        }
    }

    private static Subsumption known(String name, Robot robot) {
        return Repertoire.stack(name, robot.model())
                .orElseThrow(() -> new IllegalArgumentException(
                        "There is no behavior '%s'. %s".formatted(name, Suggestion.among(name, Repertoire.names()))));
    }

    private Subsumption written(int number, String name, Robot robot) {
        var behavior = new PythonBehavior(self, heard, number);
        own.put(number, behavior);
        return PioneerStack.safe(robot.model(), name, behavior);
    }
}
