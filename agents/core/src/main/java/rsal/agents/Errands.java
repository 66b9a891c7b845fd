package rsal.agents;

import rsal.agent.AgentContext;
import rsal.agent.message.GoalReached;
import rsal.agent.message.NewGoal;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;
import rsal.device.Subscription;

/// Drives a robot where others want it ([NewGoal]) and says how that ended ([GoalReached]). Comes before whatever
/// else its agent does: that stops for an errand and goes on after the last.
final class Errands {
    private final AgentContext self;
    private final String robot;
    private final Driver driver;
    private final Runnable before;
    private final Runnable after;
    private Subscription orders = () -> {};
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
                run(message.content());
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

    private void run(NewGoal order) {
        underWay++;
        before.run();
        self.state("driving to " + Words.place(order.mapFromGoal()));
        driver.goTo(order.mapFromGoal(), Tolerance.DEFAULT, result -> ended(order, result));
    }

    private void ended(NewGoal order, Result result) {
        underWay--;
        String ending = Words.ending(result);
        self.publish(GoalReached.TOPIC, new GoalReached(robot, order.mapFromGoal(), ending));
        if (!busy() && !over) {
            self.state("%s: %s".formatted(Words.place(order.mapFromGoal()), ending));
            after.run();
        }
    }
}
