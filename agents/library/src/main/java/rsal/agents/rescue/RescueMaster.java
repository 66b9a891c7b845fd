package rsal.agents.rescue;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import rsal.agent.AgentContext;
import rsal.agent.team.AllocationType;
import rsal.agent.team.Rules;
import rsal.agent.team.Team;
import rsal.agents.parts.AgentTypeBase;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.settings.PluginChoice;

/// Brings a helper to each victim that somebody tells of: each is a job of a team, and is never given up. Needs no
/// robot.
public final class RescueMaster extends AgentTypeBase {
    static final Parameter<PluginChoice> ALLOCATION = AllocationType.parameter();

    public RescueMaster() {
        super(
                "rescue",
                "Allocates each victim that was found to a team of helpers, by their bids.",
                List.of(ALLOCATION),
                List.of());
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        new Books(self, arguments.get(ALLOCATION)).begin();
    }

    private static final class Books {
        private final AgentContext self;
        private final Team team;
        private final Set<Integer> found = new TreeSet<>();
        private final Set<Integer> helped = new TreeSet<>();

        Books(AgentContext self, PluginChoice allocation) {
            this.self = self;
            this.team = new Team(self, Rules.DEFAULT.withTries(0).allocated(allocation), this::note);
        }

        void begin() {
            self.subscribe(VictimFound.TOPIC, message -> heard(message.sender(), message.content()));
            team.begin();
            publish();
        }

        private void heard(String sender, VictimFound said) {
            if (helped.contains(said.victim())) {
                self.send(sender, VictimHelped.TOPIC, new VictimHelped(said.victim())); // it has not heard
            } else if (found.add(said.victim())) {
                team.add(new Help(said.victim(), said.mapFromVictim()));
                publish();
            }
        }

        private void note(Team.Event event) {
            if (event instanceof Team.Event.Done(Help job, var _, var _)) {
                helped.add(job.victim());
                self.publish(VictimHelped.TOPIC, new VictimHelped(job.victim()));
                publish();
            }
        }

        private void publish() {
            self.state("%d %s found, %d helped"
                    .formatted(found.size(), found.size() == 1 ? "victim" : "victims", helped.size()));
        }
    }
}
