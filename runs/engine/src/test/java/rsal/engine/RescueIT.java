package rsal.engine;

import static java.util.stream.Collectors.groupingBy;
import static java.util.stream.Collectors.mapping;
import static java.util.stream.Collectors.toList;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.engine.report.RunEvent;
import rsal.engine.report.RunResult;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;
import rsal.testkit.LongTest;
import rsal.testkit.Trials;

@Timeout(400)
class RescueIT {
    private static final Scenario RESCUE = Scenario.load("rescue");
    private static final Pattern JOB = Pattern.compile("help(?:ing)? victim (\\d+)");

    private record Rescue(RunResult result, List<RunEvent> events) {
        double metric(String name) {
            return result.metrics().get(name).getAsDouble();
        }

        List<RunEvent> of(String kind) {
            return events.stream().filter(event -> event.kind().equals(kind)).toList();
        }

        /// Which victim a helper was after when it was gone.
        Optional<String> victimOf(String helper, double at) {
            Optional<RunEvent> last = of("agent").stream()
                    .filter(event -> event.subject().equals(helper) && seconds(event) < at)
                    .reduce((_, later) -> later);
            return last.map(event -> JOB.matcher(event.text()))
                    .filter(Matcher::matches)
                    .map(job -> job.group(1));
        }
    }

    private static double seconds(RunEvent event) {
        return event.time().toMillis() / 1000.0;
    }

    private static Rescue run(String configuration, long seed) {
        var options =
                RunOptions.NONE.withConfiguration(configuration).withSeed(seed).withSpeed(Double.POSITIVE_INFINITY);
        try (var run = LiveRun.start(RESCUE.plan(options))) {
            RunResult result = run.result()
                    .toCompletableFuture()
                    .orTimeout(300, TimeUnit.SECONDS)
                    .join();
            return new Rescue(result, run.events(0));
        }
    }

    @LongTest
    @Trials({"1", "2", "3"})
    void allVictimsAreFoundAndHelped(long seed) {
        Rescue rescue = run("virtual", seed);
        assertThat(rescue.result.outcome()).isEqualTo("success");
        assertThat(rescue.metric("found")).isEqualTo(6);
        assertThat(rescue.metric("reached")).isEqualTo(6);
        assertThat(rescue.metric("reachedTime")).isBetween(rescue.metric("foundTime"), 400.0);
        assertThat(rescue.metric("collisions")).isZero();
        assertThat(rescue.of("reached")).allMatch(event -> event.text().startsWith("has helper-"));
    }

    @Test
    @LongTest
    void explorersHelpTooWhenTheyMayAndExploreOn() {
        Rescue rescue = run("together", 1);
        assertThat(rescue.result.outcome()).isEqualTo("success");
        assertThat(rescue.of("reached")).anyMatch(event -> event.text().startsWith("has explorer-"));
        Map<String, List<String>> doings = rescue.of("agent").stream()
                .filter(event -> event.subject().startsWith("scout-"))
                .collect(groupingBy(
                        RunEvent::subject, mapping(event -> event.text().replaceAll(" victim \\d", ""), toList())));
        assertThat(doings.values())
                .anySatisfy(
                        doing -> assertThat(doing).containsSubsequence("helping", "exploring", "helping", "exploring"));
        assertThat(rescue.metric("collisions")).isZero();
    }

    @Trials({"1", "2"})
    @LongTest
    void othersTakeOverWhenSomeAreGoneAndMessagesAreLost(long seed) {
        Rescue rescue = run("faulty", seed);
        assertThat(rescue.result.outcome()).isEqualTo("success");
        assertThat(rescue.metric("reached")).isEqualTo(6);
        RunEvent fault = rescue.of("fault").stream()
                .filter(event -> event.subject().startsWith("helper-"))
                .findFirst()
                .orElseThrow();
        Optional<String> left = rescue.victimOf(fault.subject(), seconds(fault));
        assertThat(left).as("seed %d: it had a victim to help", seed).isPresent();
        assertThat(Handover.of(rescue.events, fault, fault.subject()).taken())
                .as("seed %d: another has gone there", seed)
                .isPresent();
        assertThat(rescue.of("reached"))
                .anyMatch(event -> event.subject().equals("victim-" + left.get())
                        && !event.text().contains(fault.subject())
                        && event.time().compareTo(fault.time()) > 0);
    }
}
