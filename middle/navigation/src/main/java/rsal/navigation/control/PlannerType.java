package rsal.navigation.control;

import rsal.navigation.wavefront.CostMap;
import rsal.navigation.wavefront.GlobalPlanner;
import rsal.settings.Arguments;
import rsal.settings.Plugin;

/// A kind of global planners: what plans the way that a controller drives along. Found by
/// [java.util.ServiceLoader], or a Java file that a scenario names (`navigator: {planner: Mine.java}`).
public interface PlannerType extends Plugin {
    /// One for all robots that plan over a map with the same settings.
    ///
    /// @param arguments for [#parameters]
    /// @param costs of the map for such a robot: where it can be, and how dear it is to be there
    GlobalPlanner create(Arguments arguments, CostMap costs);
}
