package rsal.agent.platform;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import rsal.agent.Directory;
import rsal.agent.Directory.Change;
import rsal.agent.ServiceDescription;
import rsal.device.Subscription;

class ServiceDescriptionTest {
    private final Run run = new Run();
    private final List<Object> log = new ArrayList<>();

    private List<String> offering(String capability) {
        return run.platform.directory().offering(capability).stream()
                .map(Directory.Entry::name)
                .toList();
    }

    @Test
    void directoryKnowsWhoOffersWhatUntilItWithdrawsOrEnds() {
        run.start("amy", self -> {
            Subscription gripper = self.offer(ServiceDescription.of("gripper"));
            self.offer(new ServiceDescription("lift", Map.of("height", "0.2 m")));
            self.scheduler().after(Duration.ofSeconds(1), gripper::cancel);
        });
        run.start("bob", self -> self.offer(ServiceDescription.of("gripper")));
        run.advance(0);
        assertThat(offering("gripper")).containsExactly("amy", "bob");
        assertThat(offering("lift")).containsExactly("amy");
        run.advance(1);
        assertThat(offering("gripper")).containsExactly("bob");
        run.platform.stop("amy");
        assertThat(offering("lift")).isEmpty();
        assertThat(run.platform.directory().capabilities("amy")).isEmpty();
    }

    @Test
    void othersAreInformedOfWhatIsOffered() {
        run.start(
                "zoe",
                self -> self.directory().onChange(change -> {
                    switch (change) {
                        case Change.Offered offered ->
                            log.add("offered " + offered.capability().details());
                        case Change.Withdrew withdrew ->
                            log.add("withdrew " + withdrew.capability().details());
                        case Change.Came _, Change.Went _ -> {}
                    }
                }));
        run.start("amy", self -> {
            Subscription first = self.offer(new ServiceDescription("lift", Map.of("height", "1")));
            Subscription second = self.offer(new ServiceDescription("lift", Map.of("height", "2")));
            first.cancel(); // was replaced
            second.cancel();
            second.cancel();
        });
        run.advance(0);
        assertThat(log).containsExactly("offered {height=1}", "offered {height=2}", "withdrew {height=2}");
    }

    @Test
    void capabilitiesHaveNames() {
        assertThatThrownBy(() -> ServiceDescription.of(" ")).isInstanceOf(IllegalArgumentException.class);
    }
}
