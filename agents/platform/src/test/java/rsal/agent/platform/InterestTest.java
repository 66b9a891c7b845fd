package rsal.agent.platform;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.agent.Interest;
import rsal.agent.message.PoseReport;
import rsal.agent.platform.AgentPlatform.Status;
import rsal.data.Pose2d;

class InterestTest {
    private final Run run = new Run();
    private final List<String> heard = new ArrayList<>();

    private void listener(Interest<PoseReport> interest) {
        run.start(
                "zoe",
                self -> self.subscribe(
                        PoseReport.TOPIC,
                        interest,
                        message -> heard.add(message.content().robot())));
    }

    private void report(String robot, String role, double x) {
        run.platform.publish(robot, PoseReport.TOPIC, new PoseReport(robot, role, new Pose2d(x, 0, 0)));
        run.advance(0);
    }

    @Test
    void onlyWhatIsWantedIsHeard() {
        listener(PoseReport.ofRobots("prey"));
        report("prey-1", "prey", 0);
        report("hunter-1", "hunter", 0);
        assertThat(heard).containsExactly("prey-1");
    }

    @Test
    void onlyWhatIsNearIsHeardAndNothingWhileItDoesNotKnowWhereItIs() {
        var here = new ArrayList<Pose2d>();
        listener(PoseReport.within(5, () -> here.stream().findFirst()));
        report("a", "r", 3);
        here.add(new Pose2d(0, 0, 1));
        report("b", "r", 3);
        report("c", "r", 5.1);
        assertThat(heard).containsExactly("b");
    }

    @Test
    void eachSenderIsHeardAtMostSoOften() {
        listener(Interest.<PoseReport>all().atMostEvery(Duration.ofSeconds(1)));
        for (int i = 0; i < 20; i++) {
            report("a", "r", 0);
            report("b", "r", 0);
            run.advance(0.1);
        }
        assertThat(heard).containsExactly("a", "b", "a", "b");
    }

    @Test
    void interestsAddUp() {
        listener(PoseReport.ofRobots("prey")
                .and(PoseReport.within(5, () -> Optional.of(new Pose2d(0, 0, 0))))
                .atMostEvery(Duration.ofSeconds(10)));
        report("a", "prey", 4);
        report("b", "prey", 6);
        report("c", "hunter", 4);
        report("a", "prey", 4);
        assertThat(heard).containsExactly("a");
    }

    @Test
    void interestThatThrowsEndsItsAgent() {
        listener(Interest.in(_ -> {
            throw new IllegalStateException("I don't know.");
        }));
        report("a", "prey", 4);
        assertThat(run.view("zoe").status()).isEqualTo(Status.FAILED);
        assertThat(run.view("zoe").state()).isEqualTo("I don't know.");
    }
}
