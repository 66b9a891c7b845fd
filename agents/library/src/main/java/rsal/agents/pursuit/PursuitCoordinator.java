package rsal.agents.pursuit;

import java.time.Duration;
import java.time.Instant;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import rsal.agent.AgentContext;
import rsal.agent.message.PoseReport;
import rsal.agent.team.Objective;
import rsal.agent.team.Rules;
import rsal.agent.team.Team;
import rsal.settings.Arguments;

/// What a team of hunters has to do: one goes for each prey that was seen and is not caught, then a second for each,
/// and so on while there are hunters. A prey of which nobody has known for a while is hunted again when it is seen.
final class PursuitCoordinator {
    private static final int MOST = 4; // after one prey
    private static final Duration LOST = Duration.ofSeconds(8); // less than hunters remember
    private static final Duration LOOK = Duration.ofSeconds(1);
    private static final double FIRST = 1000; // m, longer than any way: first one for each prey, then a second, ...

    private final AgentContext self;
    private final String prey;
    private final Team team;
    private final SortedMap<String, Instant> seen = new TreeMap<>(); // when last
    private final Set<String> lost = new HashSet<>(); // neither seen lately nor caught
    private final Set<String> caught = new HashSet<>();
    private Instant allottedAnew = Instant.EPOCH; // when last, because a hunter did not go on

    PursuitCoordinator(AgentContext self, Arguments arguments) {
        this.self = self;
        this.prey = arguments.get(HuntMaster.PREY);
        Rules rules = Rules.DEFAULT
                .withObjective(Objective.LONGEST)
                .withTries(0)
                .reconsideredEvery(arguments.seconds(HuntMaster.INTERVAL));
        this.team = new Team(self, rules, this::changed);
    }

    void begin() {
        self.subscribe(
                PoseReport.TOPIC,
                PoseReport.ofRobots(prey),
                message -> see(message.content().robot()));
        self.subscribe(Sighting.TOPIC, message -> {
            if (message.content().isOf(prey)) {
                see(message.content().robot());
            }
        });
        self.subscribe(Caught.TOPIC, message -> giveUp(message.content().prey()));
        self.scheduler().every(LOOK, this::forget);
        team.begin();
        self.state("looking for prey");
    }

    /// A prey that its hunter leaves can't wait until another is free: it would escape. Not more than once a second,
    /// for one that fails at whatever it gets.
    private void changed(Team.Event event) {
        Instant now = self.scheduler().instant();
        if (event instanceof Team.Event.Returned && !now.isBefore(allottedAnew.plus(LOOK))) {
            allottedAnew = now;
            team.reallot();
        }
        publish();
    }

    private void see(String robot) {
        lost.remove(robot);
        if (!caught.contains(robot) && seen.put(robot, self.scheduler().instant()) == null) {
            for (int number = 1; number <= MOST; number++) {
                double urgency = FIRST * (MOST - number);
                team.add(new Catch(robot, number), () -> urgency);
            }
            team.reallot();
            publish();
        }
    }

    private void giveUp(String robot) {
        caught.add(robot);
        lost.remove(robot);
        letGo(robot);
    }

    private void forget() {
        Instant then = self.scheduler().instant().minus(LOST);
        List<String> gone = seen.entrySet().stream()
                .filter(sighting -> sighting.getValue().isBefore(then))
                .map(Map.Entry::getKey)
                .filter(robot -> !caught.contains(robot))
                .toList();
        gone.forEach(robot -> {
            seen.remove(robot);
            lost.add(robot);
            letGo(robot);
        });
    }

    private void letGo(String robot) {
        for (int number = 1; number <= MOST; number++) {
            team.withdraw(new Catch(robot, number).name());
        }
        publish();
    }

    private void publish() {
        var free = new TreeSet<>(seen.keySet());
        free.removeAll(caught);
        if (free.isEmpty()) {
            boolean all = lost.isEmpty() && !caught.isEmpty();
            self.state(all ? "all that were seen are caught" : "looking for prey");
        } else {
            self.state("hunting " + String.join(", ", free));
        }
    }
}
