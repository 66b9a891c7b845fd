package rsal.ros2.simulation;

import java.util.Optional;
import java.util.function.Function;
import rsal.device.SimulationControl;
import rsal.robot.Robot;
import rsal.ros2.action.ActionServer;
import rsal.ros2.action.Services;
import rsal.ros2.link.RosLink;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;
import rsal.system.RunControl;

/// The services of the package `simulation_interfaces`, by which tools of ROS 2 control a simulator,
/// whichever it is. They are answered also while the run is paused.
public final class SimulationServer {
    private final Services services;
    private final ActionServer steps;

    /// @param node that serves them: `/rsal`
    /// @param robots by id
    /// @param restart lets the time of ROS begin again
    /// @param halt ends what programs have commanded
    /// @param link of that node
    public SimulationServer(
            String node,
            SimulationControl world,
            RunControl control,
            TruthTracker truth,
            Function<String, Optional<Robot>> robots,
            Runnable restart,
            Runnable halt,
            RosLink link,
            PublishedTime time) {
        String prefix = node + "/";
        TypeLibrary types = TypeLibrary.of(Distribution.JAZZY);
        services = new Services(link, types, control);
        new EntityServices(world, control, truth, robots, time).serve(services, prefix);
        var run = new RunServices(control, restart, halt, time::ofRun);
        run.serve(services, prefix);
        steps = new ActionServer(
                link,
                new Services(link, types, control),
                prefix + "simulate_steps",
                "simulation_interfaces/action/SimulateSteps",
                time,
                run);
    }

    public void close() {
        steps.close();
        services.close();
    }
}
