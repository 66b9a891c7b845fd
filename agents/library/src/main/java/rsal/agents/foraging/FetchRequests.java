package rsal.agents.foraging;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import rsal.agent.AgentContext;
import rsal.agent.Directory;
import rsal.agent.ServiceDescription;
import rsal.agent.protocol.Request;
import rsal.agent.protocol.Request.Asked;
import rsal.agent.team.Objective;
import rsal.agent.team.Rules;
import rsal.agent.team.Team;
import rsal.settings.Arguments;

/// What a team is asked to fetch: each thing once, no matter who asks. Says every few seconds what is to be fetched, so
/// that nobody asks for it again.
final class FetchRequests {
    private static final String SERVICE = "fetch";
    /// How often it says what is to be fetched: two of these may get lost within [Detections#MEMORY].
    static final Duration REPEAT = Duration.ofSeconds(4);

    private static final int TRIES = 3;

    private final AgentContext self;
    private final Team team;
    private final Map<String, Asked<CollectGoal, String>> open = new LinkedHashMap<>(); // by job's name

    FetchRequests(AgentContext self, Arguments arguments) {
        this.self = self;
        Rules rules = Rules.DEFAULT.withObjective(Objective.LONGEST).allocated(arguments.get(FetchMaster.ALLOCATION));
        this.team = new Team(self, rules.withTries(TRIES), this::note);
    }

    /// The service by which one asks: [CollectGoal] → where it lies now, in words.
    static Request<CollectGoal, String> service(AgentContext self) {
        return new Request<>(self, SERVICE, CollectGoal.class, String.class);
    }

    /// Whom one asks; empty while nobody is there.
    static Optional<String> master(AgentContext self) {
        return self.directory().offering(SERVICE).stream()
                .map(Directory.Entry::name)
                .findFirst();
    }

    void begin() {
        service(self).answer(this::asked);
        self.offer(ServiceDescription.of(SERVICE));
        self.scheduler()
                .every(REPEAT, () -> open.values().forEach(asked -> self.publish(CollectGoal.TOPIC, asked.what())));
        team.begin();
        publish();
    }

    private void asked(Asked<CollectGoal, String> asked) {
        if (open.values().stream().anyMatch(other -> other.what().isSame(asked.what()))) {
            asked.refuse("Somebody has asked for it already.");
            return;
        }
        asked.agree();
        var job = new Fetch(asked.what());
        open.put(job.name(), asked);
        self.publish(CollectGoal.TOPIC, asked.what());
        team.add(job);
        publish();
    }

    private void note(Team.Event event) {
        switch (event) {
            case Team.Event.Done done -> close(done).inform(done.report());
            case Team.Event.GivenUp vain -> close(vain).fail(vain.why()); // if it is there, it will be found again
            case Team.Event.Allotted _, Team.Event.Returned _ -> {}
        }
    }

    private Asked<CollectGoal, String> close(Team.Event event) {
        Asked<CollectGoal, String> asked =
                Objects.requireNonNull(open.remove(event.job().name()));
        publish();
        return asked;
    }

    private void publish() {
        self.state(open.isEmpty() ? "waiting for something to fetch" : open.size() + " to be fetched");
    }
}
