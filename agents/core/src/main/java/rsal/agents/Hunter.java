package rsal.agents;

import java.util.Optional;
import rsal.agent.AgentContext;
import rsal.agent.message.NewGoal;
import rsal.agent.message.PoseReport;
import rsal.agent.message.PoseRequest;
import rsal.agent.team.Job;
import rsal.agent.team.Worker;
import rsal.device.Navigator;
import rsal.device.Planner;
import rsal.robot.Robot;
import rsal.settings.Arguments;

/// One hunter's part of a hunt in which prey are allotted by an agent of type `hunt`: bids by what the way to each
/// would cost, and goes for the one that it gets.
final class Hunter {
    private static final double NEAR = 2.0; // m, of a prey that stands by a wall

    private final AgentContext self;
    private final Reporter reporter;
    private final Sightings sightings;
    private final Worker worker;
    private final Chasing chasing;
    private final Errands errands;

    Hunter(AgentContext self, Robot robot, Arguments arguments) {
        this.self = self;
        this.sightings = new Sightings(self.blackboard());
        this.reporter = new Reporter(self, robot, arguments, sightings::note);
        var driver = new Driver(self, robot.require(Navigator.class));
        this.chasing = new Chasing(
                self,
                robot,
                driver,
                sightings,
                reporter::mapFromBase,
                arguments.number(Follow.CATCH_DISTANCE.name()),
                arguments.seconds(Follow.UPDATE_INTERVAL.name()));
        this.worker = new Worker(
                self, new PlannedWays(robot.find(Planner.class), NEAR), reporter::mapFromBase, this::changed);
        this.worker.learn(Catch.class, chasing);
        this.errands = new Errands(self, robot.id(), driver, () -> worker.unfit("on an errand"), worker::fit);
    }

    void begin() {
        self.subscribe(PoseReport.TOPIC, message -> {
            sightings.note(message.content());
            chasing.look(message.content(), hunted());
        });
        errands.begin();
        reporter.begin();
        worker.begin();
        self.publish(PoseRequest.TOPIC, new PoseRequest(NewGoal.ALL)); // some may have been there for long
        self.state("waiting for a prey");
    }

    private Optional<Catch> hunted() {
        return worker.job().map(Catch.class::cast);
    }

    private void changed(Worker now) {
        if (now.job().isEmpty()) {
            self.state("waiting for a prey");
        }
        self.show("prey", now.job().map(Job::name).orElse("none"));
    }
}
