package rsal.agents;

import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;
import rsal.agent.message.GoalReached;
import rsal.agent.message.NewGoal;
import rsal.agent.protocol.Request;
import rsal.agent.protocol.Request.Asked;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;
import rsal.device.Subscription;

/// Drives a robot where others want it, who tell it ([NewGoal]) or ask for it ([#service]), and says how that ended
/// ([GoalReached]). Comes before whatever else its agent does: that stops for an errand and goes on after the last. The
/// newest counts.
final class Errands {
    private final AgentContext self;
    private final String robot;
    private final Driver driver;
    private final Runnable before;
    private final Runnable after;
    private Subscription orders = () -> {};
    private @Nullable NewGoal newest;
    private int underWay;
    private boolean over;

    /// @param before lets go of the robot; called before each errand
    /// @param after takes it back; called when the last errand has ended
    Errands(AgentContext self, String robot, Driver driver, Runnable before, Runnable after) {
        this.self = self;
        this.robot = robot;
        this.driver = driver;
        this.before = before;
        this.after = after;
    }

    void begin() {
        orders = self.subscribe(NewGoal.TOPIC, message -> {
            if (message.content().isFor(robot)) {
                run(message.content(), _ -> {});
            }
        });
        service(self).answer(this::answer);
    }

    /// The service by which one agent asks another to drive its robot somewhere: [NewGoal] → [GoalReached]. It fails
    /// with the ending when the robot does not get there.
    static Request<NewGoal, GoalReached> service(AgentContext self) {
        return new Request<>(self, "go", NewGoal.class, GoalReached.class);
    }

    private void answer(Asked<NewGoal, GoalReached> asked) {
        if (over || !asked.what().isFor(robot)) {
            asked.refuse(over ? "I take no more orders." : "That is for another robot.");
            return;
        }
        asked.agree();
        run(asked.what(), end -> {
            if (end.reached()) {
                asked.inform(end);
            } else {
                asked.fail(end.words());
            }
        });
        NewGoal order = asked.what();
        asked.whenUnwanted(() -> {
            if (order.equals(newest)) {
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

    boolean busy() {
        return underWay > 0;
    }

    private void run(NewGoal order, Consumer<GoalReached> onEnd) {
        underWay++;
        newest = order;
        before.run();
        self.state("driving to " + Words.place(order.mapFromGoal()));
        driver.goTo(order.mapFromGoal(), Tolerance.DEFAULT, result -> ended(order, result, onEnd));
    }

    private void ended(NewGoal order, Result result, Consumer<GoalReached> onEnd) {
        underWay--;
        var end = new GoalReached(robot, order.mapFromGoal(), Words.ending(result), Words.reason(result));
        self.publish(GoalReached.TOPIC, end);
        onEnd.accept(end);
        if (!busy() && !over) {
            self.state("%s: %s".formatted(Words.place(order.mapFromGoal()), end.words()));
            after.run();
        }
    }
}
