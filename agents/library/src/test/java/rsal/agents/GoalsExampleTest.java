package rsal.agents;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.AgentSpec;
import rsal.agent.AgentType;
import rsal.agent.bdi.Belief;
import rsal.agent.bdi.Mind;
import rsal.agent.bdi.PlanContext;
import rsal.agents.driving.NavigationClient;
import rsal.data.Pose2d;
import rsal.device.Navigator;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;
import rsal.settings.Arguments;

/// What docs/how-to/goals-and-plans.md shows, word for word, in an agent that works.
class GoalsExampleTest {
    private static final Path PAGE = Path.of("../../docs/how-to/goals-and-plans.md");
    private static final Path HERE = Path.of("src/test/java/rsal/agents/GoalsExampleTest.java");

    private final Scene scene = new Scene();
    private final FakeRobot r1 = scene.robot("r1", "rover");
    private final Collector collector = new Collector();

    private static final class Collector implements Agent, AgentType {
        private final Pose2d charger = new Pose2d(3, 4, 0);
        private final StringBuilder done = new StringBuilder();
        private NavigationClient driver;
        private Belief<Integer> known;
        private Belief<Double> charge;

        @Override
        public String key() {
            return "collector";
        }

        @Override
        public String description() {
            return "Does what the page shows.";
        }

        @Override
        public Agent create(Arguments arguments) {
            return this;
        }

        @Override
        public void start(AgentContext self) {
            driver = new NavigationClient(self, self.robot().orElseThrow().require(Navigator.class));
            // shown: goals
            var mind = new Mind(self);
            known = mind.belief("cans", 0);
            charge = mind.belief("charge", 1.0);

            mind.goal("recharge")
                    .priority(() -> 10)
                    .when(() -> charge.get() < 0.3) // its context: wanted only while this holds
                    .plan("stand at a charger", this::dock)
                    .plan("call for help", this::callForHelp); // tried when the first has failed

            mind.goal("bring cans")
                    .priority(() -> holding() ? 20 : 5) // a can in the hand comes before the battery
                    .when(() -> known.get() > 0)
                    .plan("fetch the nearest", this::fetch);

            mind.goal("find cans").priority(() -> 1).plan("look around", this::lookAround);
            mind.begin(Duration.ofSeconds(1)); // thinks whenever a belief changes, and once a second
            // end
        }

        // shown: a plan
        private void dock(PlanContext doing) {
            Runnable go = () -> driver.goTo(charger, Tolerance.DEFAULT, result -> {
                if (result instanceof Result.Stuck) {
                    doing.fail("Something is in the way."); // the next plan is tried
                }
            });
            doing.onSuspend(driver::stop).onResume(go).onEnd(driver::stop);
            go.run();
        }
        // end

        private void callForHelp(PlanContext doing) {
            done.append("help ");
        }

        private void fetch(PlanContext doing) {
            done.append("fetch ");
        }

        private void lookAround(PlanContext doing) {
            done.append("look ");
        }

        private static boolean holding() {
            return false;
        }
    }

    @Test
    void theMostUrgentGoalGetsTheRobotAndTheNextPlanIsTriedWhenOneFails() {
        var none = Arguments.defaults(List.of());
        scene.platform.start(new AgentSpec("amy", "tested", collector, none, Optional.of(r1.robot), 1));
        scene.advance(1);
        assertThat(collector.done).hasToString("look ");
        collector.known.set(2);
        scene.advance(1);
        assertThat(collector.done).hasToString("look fetch ");
        collector.charge.set(0.2);
        scene.advance(1);
        assertThat(r1.navigator.goals).containsExactly(collector.charger);
        r1.navigator.end(FakeRobot.stuck());
        scene.advance(1);
        assertThat(collector.done).hasToString("look fetch help ");
    }

    @Test
    void pageShowsJustThis() throws IOException {
        String page = packed(Files.readString(PAGE));
        List<String> parts = Arrays.stream(Files.readString(HERE).split("// " + "shown: "))
                .skip(1)
                .map(part -> part.substring(part.indexOf('\n'), part.indexOf("// end")))
                .toList();
        assertThat(parts).hasSize(2).allSatisfy(part -> assertThat(page).contains(packed(part)));
    }

    private static String packed(String text) {
        return text.replaceAll("\\s+", "");
    }
}
