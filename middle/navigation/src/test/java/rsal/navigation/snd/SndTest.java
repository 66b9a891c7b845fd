package rsal.navigation.snd;

import rsal.data.Footprint;
import rsal.navigation.avoid.Controller;
import rsal.navigation.avoid.ControllerContract;

class SndTest extends ControllerContract {
    @Override
    protected Controller planner(Footprint footprint, double reaction, double beat) {
        return new Snd(footprint, LIMITS, Snd.Settings.of(footprint), reaction);
    }
}
