package rsal.agents.pursuit;

import java.time.Duration;
import java.util.Optional;
import rsal.agent.AgentContext;
import rsal.agent.message.NewGoal;
import rsal.agent.message.PoseReport;
import rsal.agent.message.PoseRequest;
import rsal.agent.team.Job;
import rsal.agent.team.Worker;
import rsal.agents.driving.GoalService;
import rsal.agents.driving.NavigationClient;
import rsal.agents.driving.PlannedPaths;
import rsal.agents.parts.PoseReporter;
import rsal.agents.parts.TargetTracks;
import rsal.device.Navigator;
import rsal.device.Planner;
import rsal.robot.Robot;
import rsal.settings.Arguments;

/// One hunter's part of a hunt in which prey are allotted by an agent of type `hunt`: bids by what the way to each
/// would cost, and goes for the one that it gets.
final class Hunter {
    private static final double NEAR = 2.0; // m, of a prey that stands by a wall
    private static final Duration MOMENT = Duration.ofSeconds(1);

    private final AgentContext self;
    private final PoseReporter reporter;
    private final TargetTracks sightings;
    private final Worker worker;
    private final Chasing chasing;
    private final GoalService goals;
    private final PreySearch search;
    private int looks; // only the newest counts

    Hunter(AgentContext self, Robot robot, Arguments arguments) {
        this.self = self;
        this.sightings = new TargetTracks(self.blackboard());
        this.reporter = new PoseReporter(self, robot, arguments, sightings::note);
        var driver = new NavigationClient(self, robot.require(Navigator.class));
        this.chasing = new Chasing(
                self,
                robot,
                driver,
                sightings,
                reporter::mapFromBase,
                arguments.get(Follow.CATCH_DISTANCE),
                arguments.seconds(Follow.UPDATE_INTERVAL));
        this.worker = new Worker(
                self, new PlannedPaths(robot.find(Planner.class), NEAR), reporter::mapFromBase, this::changed);
        this.worker.learn(Catch.class, chasing);
        this.goals = new GoalService(self, robot.id(), driver, this::leave, this::comeBack);
        this.search = new PreySearch(self, robot, driver, reporter::mapFromBase, arguments, this::learn);
    }

    void begin() {
        search.begin();
        goals.begin();
        reporter.begin();
        worker.begin();
        self.publish(PoseRequest.TOPIC, new PoseRequest(NewGoal.ALL)); // some may have been there for long
        self.state("waiting for a prey");
    }

    private void learn(PoseReport report) {
        sightings.note(report);
        chasing.look(report, hunted());
    }

    private void leave() {
        search.pause();
        worker.unfit("on an errand");
    }

    private void comeBack() {
        worker.fit();
        lookSoon();
    }

    /// When it gets no other prey at once.
    private void lookSoon() {
        if (search.roams()) {
            int now = ++looks;
            self.scheduler().after(MOMENT, () -> {
                if (now == looks && worker.job().isEmpty() && !goals.busy()) {
                    search.goOn();
                }
            });
        }
    }

    private Optional<Catch> hunted() {
        return worker.job().map(Catch.class::cast);
    }

    private void changed(Worker now) {
        if (now.job().isEmpty()) {
            self.state("waiting for a prey");
            lookSoon();
        } else {
            looks++;
            search.pause();
        }
        self.show("prey", now.job().map(Job::name).orElse("none"));
    }
}
