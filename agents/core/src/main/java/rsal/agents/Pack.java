package rsal.agents;

import java.util.HashSet;
import java.util.Set;
import java.util.TreeSet;
import rsal.agent.AgentContext;
import rsal.agent.message.Caught;
import rsal.agent.message.PoseReport;
import rsal.agent.team.Objective;
import rsal.agent.team.Rules;
import rsal.agent.team.Team;
import rsal.settings.Arguments;

/// What a team of hunters has to do: one goes for each prey that was seen and is not caught, then a second for each,
/// and
/// so on while there are hunters.
final class Pack {
    private static final int MOST = 4; // after one prey
    private static final double FIRST = 1000; // m, longer than any way: first one for each prey, then a second, ...

    private final AgentContext self;
    private final String prey;
    private final Team team;
    private final Set<String> seen = new TreeSet<>();
    private final Set<String> caught = new HashSet<>();

    Pack(AgentContext self, Arguments arguments) {
        this.self = self;
        this.prey = arguments.text(HuntMaster.PREY.name());
        Rules rules = Rules.DEFAULT
                .withObjective(Objective.LONGEST)
                .withTries(0)
                .reconsideredEvery(arguments.seconds(HuntMaster.INTERVAL.name()));
        this.team = new Team(self, rules, _ -> tell());
    }

    void begin() {
        self.subscribe(
                PoseReport.TOPIC,
                PoseReport.ofRobots(prey),
                message -> see(message.content().robot()));
        self.subscribe(Caught.TOPIC, message -> giveUp(message.content().prey()));
        team.begin();
        self.state("looking for prey");
    }

    private void see(String robot) {
        if (!caught.contains(robot) && seen.add(robot)) {
            for (int number = 1; number <= MOST; number++) {
                double urgency = FIRST * (MOST - number);
                team.add(new Catch(robot, number), () -> urgency);
            }
            team.reallot();
            tell();
        }
    }

    private void giveUp(String robot) {
        caught.add(robot);
        for (int number = 1; number <= MOST; number++) {
            team.withdraw(new Catch(robot, number).name());
        }
        tell();
    }

    private void tell() {
        var free = new TreeSet<>(seen);
        free.removeAll(caught);
        self.state(free.isEmpty() ? "all that were seen are caught" : "hunting " + String.join(", ", free));
    }
}
