package rsal.agents;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import rsal.agent.AgentContext;
import rsal.agent.message.Caught;
import rsal.agent.message.PoseReport;
import rsal.agent.team.Objective;
import rsal.agent.team.Rules;
import rsal.agent.team.Team;
import rsal.settings.Arguments;

/// What a team of hunters has to do: of each prey that was seen and is not caught, one goes where it is, and one cuts
/// it off.
final class Pack {
    private static final double FIRST = 1000; // m, longer than any way: first one for each prey, then a second

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
            team.add(new Catch(robot, true), () -> FIRST);
            team.add(new Catch(robot, false));
            tell();
        }
    }

    private void giveUp(String robot) {
        caught.add(robot);
        List.of(true, false).forEach(behind -> team.withdraw(new Catch(robot, behind).name()));
        tell();
    }

    private void tell() {
        var free = new TreeSet<>(seen);
        free.removeAll(caught);
        self.state(free.isEmpty() ? "all that were seen are caught" : "hunting " + String.join(", ", free));
    }
}
