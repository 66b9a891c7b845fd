package rsal.navigation.control;

import rsal.navigation.jumppoint.JumpPoints;
import rsal.navigation.wavefront.CostMap;
import rsal.navigation.wavefront.GlobalPlanner;
import rsal.settings.Arguments;

/// Makes planners by [JumpPoints].
public final class JumpPointPlannerType implements PlannerType {
    @Override
    public String key() {
        return "jumppoint";
    }

    @Override
    public String description() {
        return "Plans the shortest path by jump point search. It passes walls as closely as is allowed.";
    }

    @Override
    public GlobalPlanner create(Arguments arguments, CostMap costs) {
        return new JumpPoints(costs);
    }
}
