/// Environments for learning: scenarios in which programs outside drive some of the robots, step by step, in many
/// worlds at once. Observations and actions are plugins. Knows robots and agents by their contracts only.
module rsal.environments {
    requires transitive rsal.engine;
    requires transitive rsal.python; // trained policies are agents in Python
    requires static org.jspecify;

    exports rsal.environment;

    uses rsal.environment.ActionType;
    uses rsal.environment.ObservationType;

    provides rsal.python.ObservationService with
            rsal.environment.PolicyObservations;
    provides rsal.environment.ActionType with
            rsal.environment.VelocityAction,
            rsal.environment.DiscreteAction,
            rsal.environment.CarryAction,
            rsal.environment.PlaceAction,
            rsal.environment.GoalAction;
    provides rsal.environment.ObservationType with
            rsal.environment.RangesObservation,
            rsal.environment.PoseObservation,
            rsal.environment.VelocityObservation,
            rsal.environment.NearestObservation,
            rsal.environment.MarkersObservation,
            rsal.environment.MessagesObservation,
            rsal.environment.GoalObservation,
            rsal.environment.GripperObservation,
            rsal.environment.HomeObservation,
            rsal.environment.SlotObservation,
            rsal.environment.VisitedObservation,
            rsal.environment.IdlenessObservation,
            rsal.environment.PlaceObservation;
}
