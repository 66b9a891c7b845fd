package rsal.engine.communication;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.random.RandomGenerator;
import java.util.stream.Collectors;
import rsal.device.Device;
import rsal.device.Localizer;
import rsal.device.Subscription;
import rsal.fault.Fault;
import rsal.fault.FaultInjection;
import rsal.fault.FaultyLocalizer;
import rsal.scenario.fault.PlannedFault;
import rsal.scenario.fault.PlannedFault.OfRobot;
import rsal.system.RobotSystem;

/// Breaks localizers by what it has put around them, and all else by what the robot systems have for it.
public final class RobotBreaker implements Faults.Breaker {
    private final RobotSystem system;
    private final Set<String> breaking; // all that faults can strike, by name
    private final Map<String, FaultyLocalizer> localizers = new HashMap<>(); // by the device's id
    private final Set<String> left = new HashSet<>(); // robots

    public RobotBreaker(RobotSystem system, List<PlannedFault> faults) {
        this.system = system;
        this.breaking = faults.stream()
                .flatMap(fault -> fault.targets().stream())
                .map(PlannedFault.Target::name)
                .collect(Collectors.toSet());
    }

    /// A localizer that can have a fault later, if there will be one.
    public Device breakable(Device device) {
        String id = device.info().id();
        if (breaking.contains(id) && device instanceof Localizer localizer) {
            var faulty = new FaultyLocalizer(localizer);
            localizers.put(id, faulty);
            return faulty;
        }
        return device;
    }

    /// A robot was taken out of the world, with all of its devices.
    public void leave(String robot) {
        localizers.values().removeIf(localizer -> localizer.info().robot().equals(robot));
        left.add(robot);
    }

    @Override
    public Optional<String> refusal(OfRobot broken) {
        if (left.contains(broken.robot())) {
            return Optional.of("There is no robot '%s'.".formatted(broken.robot()));
        }
        return localizers.containsKey(broken.name())
                ? Optional.empty()
                : injection().refusal(broken.robot(), broken.device(), broken.fault());
    }

    @Override
    public Subscription begin(OfRobot broken, RandomGenerator random) {
        FaultyLocalizer localizer = localizers.get(broken.name());
        if (localizer != null && broken.fault() instanceof Fault.OfSensor ofSensor) {
            return localizer.begin(ofSensor, random);
        }
        return injection().begin(broken.robot(), broken.device(), broken.fault(), random);
    }

    private FaultInjection injection() {
        return system.faults().orElseThrow();
    }
}
