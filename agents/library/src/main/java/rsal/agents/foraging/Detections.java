package rsal.agents.foraging;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import rsal.agent.AgentContext;
import rsal.agent.message.PoseReport;
import rsal.agent.protocol.ConversationResult;
import rsal.agent.protocol.Request;
import rsal.agents.parts.TargetTracks;
import rsal.data.Point2d;

/// What was found, by oneself and by others, and is to be fetched: new things are asked for ([FetchRequests]). A thing
/// is new if nobody has reported for ten seconds that it is taken care of. It must lie in no depot, and not where a
/// robot is, which may carry it.
final class Detections {
    /// How long is remembered what is not heard of again.
    static final Duration MEMORY = Duration.ofSeconds(10);

    private static final double AROUND_ROBOTS = 0.8; // m, in which one carries things, and goes on between two reports

    private final AgentContext self;
    private final TargetTracks robots;
    private final Depots depots;
    private final Request<CollectGoal, String> orders;
    private final List<CollectGoal> asked = new ArrayList<>();
    private int noted;

    Detections(AgentContext self) {
        this.self = self;
        this.robots = new TargetTracks(self.blackboard());
        this.depots = new Depots(self);
        this.orders = FetchRequests.service(self);
    }

    void begin() {
        self.subscribe(CollectGoal.TOPIC, message -> note(message.content()));
        depots.listen();
        self.subscribe(PoseReport.TOPIC, message -> robots.note(message.content()));
    }

    /// Something is seen: now, or still.
    void see(CollectGoal seen) {
        if (!isKnown(seen) && !depots.hold(seen.mapFromThing()) && !isWhereARobotIs(seen.mapFromThing())) {
            ask(seen);
        }
    }

    /// Has it fetched, as soon as there is somebody to ask.
    private void ask(CollectGoal found) {
        FetchRequests.master(self).ifPresent(master -> {
            asked.add(found);
            publish();
            orders.ask(master, found, ending -> {
                asked.remove(found); // when it still lies there, it will be seen again
                if (ending instanceof ConversationResult.Refused) {
                    note(found);
                }
                publish();
            });
        });
    }

    private void publish() {
        self.show("things", asked.isEmpty() ? "none" : asked.size() + " to be fetched");
    }

    private boolean isKnown(CollectGoal seen) {
        return asked.stream().anyMatch(seen::isSame)
                || self.blackboard().read(CollectGoal.TOPIC).stream()
                        .anyMatch(note -> note.content().isSame(seen));
    }

    private void note(CollectGoal goal) {
        String name = self.blackboard().read(CollectGoal.TOPIC).stream()
                .filter(note -> note.content().isSame(goal))
                .map(note -> note.name())
                .findFirst()
                .orElseGet(() -> "thing-" + ++noted);
        self.blackboard().write(CollectGoal.TOPIC, name, goal, MEMORY);
    }

    private boolean isWhereARobotIs(Point2d mapFromThing) {
        return robots.of(_ -> true).values().stream()
                .anyMatch(robot -> robot.position().distanceTo(mapFromThing) < AROUND_ROBOTS);
    }
}
