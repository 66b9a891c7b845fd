package rsal.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.settings.FileSource;

/// What agents need of their robots, as their arguments have it.
class NeedsTest {
    private static final String SCENARIO = """
            rsal: 1
            scenario: needs
            arguments:
              sees: {type: string, default: reports}
            world: {map: office}
            robots:
              cart:
                model: pioneer2dx
                pose: [0, -1, 0]
                devices: {laser: urg04lx, localizer: amcl, planner: wavefront, navigator: {}%s}
            agents:
              one: {type: %s, robot: cart, parameters: {%s}}
            """;

    private static RunPlan plan(String agent, @Nullable String arguments, @Nullable String devices) {
        return Scenario.read("needs.yaml", SCENARIO.formatted(devices, agent, arguments), FileSource.disk())
                .plan(RunOptions.NONE);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            nullValues = "none",
            value = {
                "follow | with 'sees: fiducials' | prey: cart, sees: fiducials | , pilot: {}, places: {} | a"
                        + " FiducialFinder",
                "follow | with 'sees: fiducials' | prey: cart, sees: fiducials | , fiducials: fiducials180, places: {} | a"
                        + " Pilot",
                "follow | with 'sees: fiducials' | prey: cart, sees: fiducials | none | a FiducialFinder and a Pilot and a"
                        + " PlaceFinder",
                "escape | with 'sees: fiducials' | sees: fiducials | , pilot: {} | a FiducialFinder",
                "evade | with 'sees: fiducials' | sees: fiducials | , pilot: {} | a FiducialFinder",
                "evade | with 'sees: fiducials' | sees: fiducials | none | a Pilot and a FiducialFinder",
                "explore | with 'roam: viewpoints' | roam: viewpoints | , pilot: {}, camera: blob-camera | a PlaceFinder",
                "worker | with 'intruder: #d55e00' | intruder: '#d55e00' | none | a BlobFinder",
                "escape | none | sees: reports | none | a Pilot"
            })
    void whatIsMissingIsReportedWithTheArgumentThatNeedsIt(
            String agent, @Nullable String which, String arguments, @Nullable String devices, String missing) {
        assertThatThrownBy(() -> plan(agent, arguments, devices == null ? "" : devices))
                .hasMessageContaining("needs.yaml:12:")
                .hasMessageContaining("Agent '%s' %sneeds a robot with %s, which"
                        .formatted(agent, which == null ? "" : which + " ", missing))
                .hasMessageContaining("which robots of role 'cart' don't have.")
                .hasMessageContaining("Add it to 'robots.cart.devices'.");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            nullValues = "none",
            value = {
                "follow | prey: cart, sees: fiducials | , pilot: {}, places: {}, fiducials: fiducials180",
                "follow | prey: cart | none",
                "escape | sees: fiducials | , pilot: {}, fiducials: fiducials180",
                "escape | none | , pilot: {}",
                "worker | none | none"
            })
    void nothingIsMissingThatNoArgumentNeeds(String agent, @Nullable String arguments, @Nullable String devices) {
        assertThat(plan(agent, arguments == null ? "" : arguments, devices == null ? "" : devices)
                        .agents())
                .hasSize(1);
    }

    @Test
    void anArgumentOfTheScenarioCountsAsItIsSet() {
        Scenario scenario = Scenario.read(
                "needs.yaml", SCENARIO.formatted(", pilot: {}", "escape", "sees: $sees"), FileSource.disk());
        assertThat(scenario.plan(RunOptions.NONE).agents()).hasSize(1);
        var markers = RunOptions.NONE.withArguments(Map.of("sees", "fiducials"));
        assertThatThrownBy(() -> scenario.plan(markers)).hasMessageContaining("with 'sees: fiducials' needs");
    }

    /// Each would take it from the other, and both would get nowhere.
    @Test
    void twoAgentsThatDriveOneRobotAreRefusedUnlessOneYields() {
        String two = SCENARIO.formatted(", pilot: {}", "nav", "") + "  two: {type: wander, robot: cart%s}\n";
        assertThatThrownBy(() -> Scenario.read("two.yaml", two.formatted(""), FileSource.disk())
                        .plan(RunOptions.NONE))
                .hasMessageContaining("two.yaml:13:")
                .hasMessageContaining("Agents 'one' and 'two' both drive robot 'cart'")
                .hasMessageContaining("'yields: true'");
        assertThat(Scenario.read("two.yaml", two.formatted(", yields: true"), FileSource.disk())
                        .plan(RunOptions.NONE)
                        .agents())
                .hasSize(2);
    }

    /// One that does not drive may be beside one that does.
    @Test
    void anAgentThatDoesNotDriveMayBeOnARobotWithOneThatDoes() {
        String two = SCENARIO.formatted(", pilot: {}", "nav", "") + "  two: {type: view, robot: cart}\n";
        assertThat(Scenario.read("two.yaml", two, FileSource.disk())
                        .plan(RunOptions.NONE)
                        .agents())
                .hasSize(2);
    }

    /// Such a hunt went on for ever, and said nothing.
    @Test
    void whoWaitsForTasksOfAnAgentThatIsNotThereIsRefused() {
        var hunt = Scenario.load("hunt-and-prey");
        assertThatThrownBy(() -> hunt.plan(RunOptions.NONE.withArguments(Map.of("assignment", "bids"))))
                .hasMessageContaining("Agent 'follow' of type 'follow' waits for tasks of an agent of type 'hunt',")
                .hasMessageContaining("Add one (hunt: {type: hunt}), or change the parameters of 'follow'.");
        assertThat(hunt.plan(RunOptions.NONE.withConfiguration("advanced"))).isNotNull();
        assertThat(hunt.plan(RunOptions.NONE.withArguments(Map.of("assignment", "nearest"))))
                .isNotNull();
    }
}
