package rsal.agents.driving;

import java.time.Duration;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import rsal.agent.AgentContext;
import rsal.agent.Directory;
import rsal.agent.Message;
import rsal.agent.message.GoalReached;
import rsal.agent.message.NewGoal;
import rsal.agent.presence.FailureDetector;
import rsal.agent.protocol.ConversationResult;
import rsal.agent.protocol.Request;
import rsal.agent.protocol.RetryPolicy;
import rsal.settings.Arguments;

/// Hears where people send robots, and asks each for the same by request, which is repeated until the robot has heard
/// it: the word of people may have got lost. Who falls silent on its way is told of ([GoalReached]), and asked again
/// once it is back; the newest word counts.
final class Dispatching {
    private static final String OPERATOR = "operator";
    private static final Duration ROUND = Duration.ofSeconds(1);

    private final AgentContext self;
    private final String robots;
    private final RetryPolicy patience;
    private final FailureDetector roll;
    private final Request<NewGoal, GoalReached> drives;
    private final Map<String, NewGoal> open = new TreeMap<>(); // newest of each robot that has not told its result
    private final Set<String> reported = new HashSet<>(); // robots of whose silence people know
    private final Set<String> ours = new HashSet<>(); // agents; the directory knows none that has ended
    private final SortedSet<String> answering = new TreeSet<>(); // robots
    private final SortedSet<String> silent = new TreeSet<>(); // robots

    Dispatching(AgentContext self, Arguments arguments) {
        this.self = self;
        this.robots = arguments.get(Dispatch.ROBOTS);
        Duration silence = arguments.seconds(Dispatch.TIMEOUT);
        this.patience = new RetryPolicy(ROUND, silence);
        this.roll = new FailureDetector(self, ROUND, silence, this::note);
        this.drives = GoalService.service(self);
    }

    void begin() {
        self.subscribe(NewGoal.TOPIC, this::heard);
        roll.begin();
        publish();
    }

    private void heard(Message<NewGoal> message) {
        if (!message.sender().equals(OPERATOR)) {
            return; // agents see to it themselves
        }
        NewGoal order = message.content();
        self.directory().agents().stream()
                .filter(agent -> !agent.robot().isEmpty() && order.isFor(agent.robot()) && isOurs(agent))
                .map(Directory.Entry::robot)
                .distinct()
                .forEach(robot -> {
                    var own = new NewGoal(robot, order.mapFromGoal());
                    open.put(robot, own);
                    reported.remove(robot);
                    ask(own);
                });
    }

    private void ask(NewGoal order) {
        agentOf(order.robot())
                .ifPresent(agent -> drives.ask(agent, order, patience, ending -> {
                    if (order.equals(open.get(order.robot()))) { // else it was sent elsewhere since
                        ended(order, ending);
                    }
                }));
    }

    private void ended(NewGoal order, ConversationResult<GoalReached> ending) {
        if (!(ending instanceof ConversationResult.Silent<GoalReached>)) {
            open.remove(order.robot()); // the robot has told itself the result
        } else if (answering.contains(order.robot())) {
            ask(order); // only what it answers got lost
        } else {
            report(order);
        }
    }

    /// Once for each time that people send it.
    private void report(NewGoal order) {
        if (reported.add(order.robot())) {
            self.publish(
                    GoalReached.TOPIC,
                    new GoalReached(order.robot(), order.mapFromGoal(), "silent", "Nothing is heard of it."));
        }
    }

    private void note(FailureDetector.Change change) {
        String agent = change.member().name();
        String robot = change.member().robot();
        if (change instanceof FailureDetector.Change.Appeared
                && !robot.isEmpty()
                && self.directory().find(agent).filter(this::isOurs).isPresent()) {
            ours.add(agent);
        }
        if (!ours.contains(agent)) {
            return;
        }
        switch (change) {
            case FailureDetector.Change.Appeared _ -> answering.add(robot);
            case FailureDetector.Change.CameBack _ -> {
                silent.remove(robot);
                answering.add(robot);
                Optional.ofNullable(open.get(robot)).ifPresent(this::ask);
            }
            case FailureDetector.Change.FellSilent _ -> {
                answering.remove(robot);
                silent.add(robot);
                Optional.ofNullable(open.get(robot)).ifPresent(this::report);
            }
            case FailureDetector.Change.Left _ -> {
                ours.remove(agent);
                answering.remove(robot);
                silent.remove(robot);
                Optional.ofNullable(open.remove(robot)).ifPresent(this::report);
            }
        }
        publish();
    }

    private void publish() {
        if (answering.isEmpty() && silent.isEmpty()) {
            self.state("looking who is there");
        } else {
            self.state("%d of %d robots answer".formatted(answering.size(), answering.size() + silent.size())
                    + (silent.isEmpty() ? "" : ", silent: " + String.join(", ", silent)));
        }
    }

    private boolean isOurs(Directory.Entry agent) {
        return robots.equals(NewGoal.ALL) || robots.equals(agent.robotRole()) || robots.equals(agent.robot());
    }

    private Optional<String> agentOf(String robot) {
        return self.directory().agents().stream()
                .filter(agent -> agent.robot().equals(robot))
                .map(Directory.Entry::name)
                .findFirst();
    }
}
