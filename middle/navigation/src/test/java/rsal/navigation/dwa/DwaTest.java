package rsal.navigation.dwa;

import rsal.data.Footprint;
import rsal.navigation.avoid.LocalPlanner;
import rsal.navigation.avoid.LocalPlannerContract;

class DwaTest extends LocalPlannerContract {
    @Override
    protected LocalPlanner planner(Footprint footprint, double reaction, double beat) {
        return new Dwa(footprint, LIMITS, Dwa.Settings.of(0.25, 3), reaction);
    }
}
