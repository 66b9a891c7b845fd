package rsal.navigation.nd;

import rsal.data.Footprint;
import rsal.navigation.avoid.Controller;
import rsal.navigation.avoid.ControllerContract;

class NdTest extends ControllerContract {
    @Override
    protected Controller planner(Footprint footprint, double reaction, double beat) {
        return new Nd(footprint, LIMITS, Nd.Settings.DEFAULT, reaction);
    }
}
