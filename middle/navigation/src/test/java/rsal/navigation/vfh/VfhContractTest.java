package rsal.navigation.vfh;

import rsal.data.Footprint;
import rsal.navigation.avoid.Controller;
import rsal.navigation.avoid.ControllerContract;

class VfhContractTest extends ControllerContract {
    @Override
    protected Controller planner(Footprint footprint, double reaction, double beat) {
        return new Vfh(footprint, LIMITS, Vfh.Settings.of(1.4, 0.1, 0.3), reaction);
    }
}
