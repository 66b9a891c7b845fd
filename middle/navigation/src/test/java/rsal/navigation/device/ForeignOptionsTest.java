package rsal.navigation.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

class ForeignOptionsTest {
    private final NavigatorDriver driver = new NavigatorDriver();

    /// All of Player's vfh, nd and snd.
    @ParameterizedTest
    @ValueSource(
            strings = {
                "cell_size",
                "window_diameter",
                "sector_angle",
                "safety_dist_0ms",
                "safety_dist_1ms",
                "max_speed",
                "max_speed_narrow_opening",
                "max_speed_wide_opening",
                "max_acceleration",
                "min_turnrate",
                "max_turnrate_0ms",
                "max_turnrate_1ms",
                "min_turn_radius_safety_factor",
                "free_space_cutoff_0ms",
                "free_space_cutoff_1ms",
                "obs_cutoff_0ms",
                "obs_cutoff_1ms",
                "weight_desired_dir",
                "weight_current_dir",
                "distance_epsilon",
                "angle_epsilon",
                "escape_speed",
                "escape_time",
                "escape_max_turnrate",
                "synchronous",
                "goal_tol",
                "min_speed",
                "avoid_dist",
                "safety_dist",
                "rotate_stuck_time",
                "translate_stuck_time",
                "translate_stuck_dist",
                "translate_stuck_angle",
                "wait_on_stall",
                "laser_buffer",
                "sonar_buffer",
                "sonar_bad_transducers",
                "robot_radius",
                "min_gap_width",
                "obstacle_avoid_dist",
                "max_turn_rate",
                "goal_position_tol",
                "goal_angle_tol"
            })
    void whoComesFromPlayerIsInformedWhatToWrite(String option) {
        assertThat(driver.advice(option)).isPresent();
    }

    @Test
    void advicesNameWhatThereIs() {
        assertThat(driver.advice("min_gap_width"))
                .hasValue("It belongs to the controller: 'controller: {type: snd, minGapWidth: …}'.");
        assertThat(driver.advice("max_radius").orElseThrow()).contains("comfortDistance");
        assertThat(driver.parameters()).extracting(Parameter::name).contains("comfortDistance", "wallCost", "timeout");
        assertThat(driver.advice("safety_dist").orElseThrow())
                .contains("'safetyDist'", "'wallDistance'", "'safetyDist0ms'");
        assertThat(driver.advice("goalDistance").orElseThrow()).contains("of planners");
        assertThat(driver.advice("colour")).isEqualTo(Optional.empty());
    }

    @Test
    void whoComesFromRosIsInformedWhatToWrite() {
        assertThat(driver.advice("xy_goal_tolerance").orElseThrow()).contains("its own tolerance");
        assertThat(new AmclDriver().advice("laser_max_beams")).hasValue("It is 'beams' here.");
        assertThat(new AmclDriver().advice("min_particles")).hasValue("It is written 'minParticles' here.");
        assertThat(new AmclDriver().advice("odom_alpha1").orElseThrow()).contains("odometryNoiseScale");
        assertThat(new WavefrontDriver().advice("inflation_radius")).hasValue("It is 'comfortDistance' here.");
        assertThat(new WavefrontDriver().advice("safety_dist")).hasValue("It is 'wallDistance' here.");
        assertThat(new JumpPointDriver().advice("tolerance")).hasValue("It is 'goalDistance' here.");
    }

    @Test
    void noMoreParticlesAreAskedForThanMayBe() {
        var amcl = new AmclDriver();
        assertThat(amcl.refusal(Arguments.of(amcl.parameters(), Map.of("minParticles", 9000)))
                        .orElseThrow())
                .contains("(5000)", "(9000)");
        assertThat(amcl.refusal(Arguments.defaults(amcl.parameters()))).isEmpty();
    }

    @Test
    void whatIsOfAControllerStandsInItsGroup() {
        assertThat(driver.advice("local")).hasValue("It is 'controller' here: 'controller: {type: vfh}'.");
        assertThat(driver.advice("avoidDist"))
                .hasValue("It belongs to the controller: 'controller: {type: nd, avoidDist: …}'.");
    }
}
