package rsal.agents.patrol;

import java.util.Optional;
import rsal.agent.AgentContext;
import rsal.agent.team.Skill;
import rsal.agent.team.TaskRoute;
import rsal.agent.team.Work;
import rsal.agents.driving.NavigationClient;
import rsal.agents.parts.AgentWords;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;

/// The skill to go to places and stay there for a while.
public final class Visiting implements Skill<Visit> {
    private static final Tolerance NEAR = Tolerance.position(0.5);
    private static final double SPEED = 0.4; // m/s, to tell what standing is worth

    private final AgentContext self;
    private final String robot;
    private final NavigationClient driver;

    public Visiting(AgentContext self, String robot, NavigationClient driver) {
        this.self = self;
        this.robot = robot;
        this.driver = driver;
    }

    @Override
    public Optional<TaskRoute> course(Visit job) {
        return job.robot().filter(only -> !only.equals(robot)).isPresent()
                ? Optional.empty()
                : Optional.of(new TaskRoute(
                        job.mapFromPlace(),
                        job.mapFromPlace(),
                        SPEED * job.stay().toMillis() / 1000.0));
    }

    @Override
    public void begin(Visit job, Work work) {
        self.state(job.name());
        driver.goTo(job.mapFromPlace(), NEAR, result -> arrived(job, work, result));
        work.onEnd(() -> {
            if (driver.mapFromGoal().filter(job.mapFromPlace()::equals).isPresent()) {
                driver.stop();
            }
        });
    }

    private void arrived(Visit job, Work work, Result result) {
        if (result instanceof Result.Reached) {
            self.scheduler().after(job.stay(), () -> work.done("visited"));
        } else {
            String why = AgentWords.reason(result);
            work.fail(why.isEmpty() ? AgentWords.ending(result) : AgentWords.ending(result) + ". " + why);
        }
    }
}
