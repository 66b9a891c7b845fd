package rsal.navigation.vfh;

import rsal.data.Footprint;
import rsal.navigation.avoid.LocalPlanner;
import rsal.navigation.avoid.LocalPlannerContract;

class VfhContractTest extends LocalPlannerContract {
    @Override
    protected LocalPlanner planner(Footprint footprint, double reaction, double beat) {
        return new Vfh(footprint, LIMITS, Vfh.Settings.of(1.4, 0.1, 0.3), reaction);
    }
}
