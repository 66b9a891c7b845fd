package rsal.navigation.nd;

import rsal.data.Footprint;
import rsal.navigation.avoid.LocalPlanner;
import rsal.navigation.avoid.LocalPlannerContract;

class NdTest extends LocalPlannerContract {
    @Override
    protected LocalPlanner planner(Footprint footprint, double reaction, double beat) {
        return new Nd(footprint, LIMITS, Nd.Settings.DEFAULT, reaction);
    }
}
