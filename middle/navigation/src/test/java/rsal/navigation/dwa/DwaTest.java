package rsal.navigation.dwa;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Footprint;
import rsal.navigation.avoid.Controller;
import rsal.navigation.avoid.ControllerContract;

class DwaTest extends ControllerContract {
    @Override
    protected Controller planner(Footprint footprint, double reaction, double beat) {
        return new Dwa(footprint, LIMITS, Dwa.Settings.of(0.25, 3), reaction);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void tellsAWayThatIsFree(long seed) {
        assertTellsFreeWays(seed, 0);
    }
}
