package rsal.agents;

import java.time.Duration;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.AgentType;
import rsal.agent.message.Caught;
import rsal.agent.message.PoseReport;
import rsal.agent.presence.Presence;
import rsal.agent.team.Objective;
import rsal.agent.team.Rules;
import rsal.agent.team.Team;
import rsal.device.Device;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Has a team catch prey: hunters that bid (`follow` with `assignment: bids`) each get a prey so that no way is
/// long, as long as there are enough one to go where each prey is and one to cut it off, and again and again while
/// they move. Needs no robot.
public final class HuntMaster implements Agent {
    static final Parameter PREY =
            Parameter.robots("prey", "prey", List.of(), "Role of the robots to hunt, or id of the one.");
    static final Parameter INTERVAL =
            Parameter.number("interval", 4, 0.5, 600, "s", "How often all prey are allotted anew.");

    private static final double FIRST = 1000; // m, longer than any way: first one for each prey, then a second

    private final Arguments arguments;
    private final Set<String> seen = new TreeSet<>();
    private final Set<String> caught = new HashSet<>();

    HuntMaster(Arguments arguments) {
        this.arguments = arguments;
    }

    @Override
    public void start(AgentContext self) {
        Duration interval = arguments.seconds(INTERVAL.name());
        Rules rules =
                Rules.DEFAULT.withObjective(Objective.LONGEST).withTries(0).reconsideredEvery(interval);
        var team = new Team(self, rules, _ -> tell(self));
        String prey = arguments.text(PREY.name());
        self.subscribe(PoseReport.TOPIC, PoseReport.ofRobots(prey), message -> {
            String robot = message.content().robot();
            if (!caught.contains(robot) && seen.add(robot)) {
                team.add(new Catch(robot, true), () -> FIRST);
                team.add(new Catch(robot, false));
                tell(self);
            }
        });
        self.subscribe(Caught.TOPIC, message -> {
            String robot = message.content().prey();
            caught.add(robot);
            List.of(true, false).forEach(behind -> team.withdraw(new Catch(robot, behind).name()));
            tell(self);
        });
        team.begin();
        Presence.begin(self);
        self.state("looking for prey");
    }

    private void tell(AgentContext self) {
        var free = new TreeSet<>(seen);
        free.removeAll(caught);
        self.state(free.isEmpty() ? "all that were seen are caught" : "hunting " + String.join(", ", free));
    }

    @Override
    public void stop(AgentContext self) {
        Presence.end(self);
    }

    public static final class Type implements AgentType {
        @Override
        public String key() {
            return "hunt";
        }

        @Override
        public String description() {
            return "Has a team of hunters that bid catch prey, the nearest for each, and surround them.";
        }

        @Override
        public List<Parameter> parameters() {
            return List.of(PREY, INTERVAL);
        }

        @Override
        public List<Class<? extends Device>> needs() {
            return List.of();
        }

        @Override
        public Agent create(Arguments arguments) {
            return new HuntMaster(arguments);
        }
    }
}
