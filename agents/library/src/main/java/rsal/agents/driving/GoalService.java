package rsal.agents.driving;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;
import rsal.agent.message.GoalReached;
import rsal.agent.message.NewGoal;
import rsal.agent.protocol.Request;
import rsal.agent.protocol.Request.Asked;
import rsal.agents.parts.AgentWords;
import rsal.data.Pose2d;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;
import rsal.device.Subscription;

/// Drives a robot where others want it, who tell it ([NewGoal]) or ask for it ([#service]), and says how that ended
/// ([GoalReached]). Comes before whatever else its agent does: that stops for an errand and goes on after the last. The
/// newest counts; who wants the robot where it is on its way to already joins those who wait.
public final class GoalService {
    private final AgentContext self;
    private final String robot;
    private final NavigationClient driver;
    private final Runnable before;
    private final Runnable after;
    private Subscription orders = () -> {};
    private @Nullable GoalRequest newest;
    private int inProgress;
    private boolean over;

    /// @param before lets go of the robot; called before each errand
    /// @param after takes it back; called when the last errand has ended
    public GoalService(AgentContext self, String robot, NavigationClient driver, Runnable before, Runnable after) {
        this.self = self;
        this.robot = robot;
        this.driver = driver;
        this.before = before;
        this.after = after;
    }

    public void begin() {
        orders = self.subscribe(NewGoal.TOPIC, message -> {
            if (message.content().isFor(robot)) {
                run(message.content(), new Waiting(_ -> {}));
            }
        });
        service(self).answer(this::answer);
    }

    /// The service by which one agent asks another to drive its robot somewhere: [NewGoal] → [GoalReached]. It fails
    /// with the ending when the robot does not get there.
    public static Request<NewGoal, GoalReached> service(AgentContext self) {
        return new Request<>(self, "go", NewGoal.class, GoalReached.class);
    }

    private void answer(Asked<NewGoal, GoalReached> asked) {
        if (over || !asked.what().isFor(robot)) {
            asked.refuse(over ? "I take no more orders." : "That is for another robot.");
            return;
        }
        asked.agree();
        var waiting = new Waiting(end -> {
            if (end.there()) {
                asked.inform(end);
            } else {
                asked.fail(end.outcome());
            }
        });
        GoalRequest goal = run(asked.what(), waiting);
        asked.whenUnwanted(() -> {
            goal.waiting.remove(waiting);
            if (goal.waiting.isEmpty() && goal.equals(newest)) {
                driver.stop();
            }
        });
    }

    /// Takes no more orders and drops the one under way.
    void end() {
        over = true;
        orders.cancel();
        driver.stop();
    }

    public boolean busy() {
        return inProgress > 0;
    }

    private GoalRequest run(NewGoal order, Waiting waiting) {
        Pose2d mapFromGoal = order.mapFromGoal();
        if (newest != null && isInProgress(newest, mapFromGoal)) {
            newest.waiting.add(waiting);
            return newest;
        }
        var goal = new GoalRequest(mapFromGoal);
        goal.waiting.add(waiting);
        inProgress++;
        newest = goal;
        before.run();
        self.state("driving to " + AgentWords.place(mapFromGoal));
        driver.goTo(mapFromGoal, Tolerance.DEFAULT, result -> ended(goal, result));
        return goal;
    }

    private boolean isInProgress(GoalRequest goal, Pose2d mapFromGoal) {
        return busy()
                && goal.mapFromGoal.equals(mapFromGoal)
                && driver.mapFromGoal().filter(mapFromGoal::equals).isPresent();
    }

    private void ended(GoalRequest goal, Result result) {
        inProgress--;
        var end = new GoalReached(robot, goal.mapFromGoal, AgentWords.ending(result), AgentWords.reason(result));
        self.publish(GoalReached.TOPIC, end);
        List.copyOf(goal.waiting).forEach(waiting -> waiting.onEnd.accept(end));
        if (!busy() && !over) {
            self.state("%s: %s".formatted(AgentWords.place(goal.mapFromGoal), end.outcome()));
            after.run();
        }
    }

    /// A drive, and who waits for its end.
    private static final class GoalRequest {
        private final Pose2d mapFromGoal;
        private final List<Waiting> waiting = new ArrayList<>();

        GoalRequest(Pose2d mapFromGoal) {
            this.mapFromGoal = mapFromGoal;
        }
    }

    private static final class Waiting {
        private final Consumer<GoalReached> onEnd;

        Waiting(Consumer<GoalReached> onEnd) {
            this.onEnd = onEnd;
        }
    }
}
