package rsal.agents;

import java.time.Duration;
import rsal.agent.AgentContext;
import rsal.agent.message.CollectGoal;
import rsal.agent.message.Depot;
import rsal.agent.message.PoseReport;
import rsal.data.Point2d;

/// What was found, by oneself and by others. New is a thing of which nobody has said for ten seconds that it is taken
/// care of, that lies in no depot, and that is not where a robot is, which may carry it.
final class Finds {
    /// How long is remembered what is not heard of again.
    static final Duration MEMORY = Duration.ofSeconds(10);

    private static final double AROUND_ROBOTS = 0.8; // m, in which one carries things, and goes on between two reports

    private final AgentContext self;
    private final Sightings robots;
    private final Hiring hiring;
    private int noted;

    /// @param hiring has what is new collected
    Finds(AgentContext self, Hiring hiring) {
        this.self = self;
        this.robots = new Sightings(self.blackboard());
        this.hiring = hiring;
    }

    void begin() {
        self.subscribe(CollectGoal.TOPIC, message -> note(message.content()));
        self.subscribe(Depot.TOPIC, message -> {
            Depot depot = message.content();
            self.blackboard().write(Depot.TOPIC, depot.robot(), depot);
        });
        self.subscribe(PoseReport.TOPIC, message -> robots.note(message.content()));
    }

    /// Something is seen: now, or still.
    void see(CollectGoal seen) {
        if (!isKnown(seen) && !isInADepot(seen.mapFromThing()) && !isWhereARobotIs(seen.mapFromThing())) {
            note(seen);
            self.publish(CollectGoal.TOPIC, seen);
            hiring.add(seen);
        }
    }

    private boolean isKnown(CollectGoal seen) {
        return hiring.isUnderWay(seen)
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

    private boolean isInADepot(Point2d mapFromThing) {
        return self.blackboard().read(Depot.TOPIC).stream()
                .anyMatch(note -> note.content().holds(mapFromThing));
    }

    private boolean isWhereARobotIs(Point2d mapFromThing) {
        return robots.of(_ -> true).values().stream()
                .anyMatch(robot -> robot.position().distanceTo(mapFromThing) < AROUND_ROBOTS);
    }
}
