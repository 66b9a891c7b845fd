package rsal.navigation.snd;

import rsal.data.Footprint;
import rsal.navigation.avoid.LocalPlanner;
import rsal.navigation.avoid.LocalPlannerContract;

class SndTest extends LocalPlannerContract {
    @Override
    protected LocalPlanner planner(Footprint footprint, double reaction, double beat) {
        return new Snd(footprint, LIMITS, Snd.Settings.of(footprint), reaction);
    }
}
