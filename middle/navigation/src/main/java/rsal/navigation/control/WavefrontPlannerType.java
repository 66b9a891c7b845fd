package rsal.navigation.control;

import rsal.navigation.wavefront.CostMap;
import rsal.navigation.wavefront.GlobalPlanner;
import rsal.navigation.wavefront.Wavefront;
import rsal.settings.Arguments;

/// Makes planners by [Wavefront].
public final class WavefrontPlannerType implements PlannerType {
    @Override
    public String key() {
        return "wavefront";
    }

    @Override
    public String description() {
        return "Plans the path of least cost, away from walls, by a wavefront from the goal (NF1 with costs).";
    }

    @Override
    public GlobalPlanner create(Arguments arguments, CostMap costs) {
        return new Wavefront(costs);
    }
}
