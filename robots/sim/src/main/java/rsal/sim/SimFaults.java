package rsal.sim;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.random.RandomGenerator;
import java.util.stream.Collectors;
import rsal.device.Device;
import rsal.device.Subscription;
import rsal.fault.Fault;
import rsal.fault.FaultInjection;
import rsal.fault.SensorFaults;
import rsal.sim.world.Body;

/// Breaks simulated robots.
final class SimFaults implements FaultInjection {
    private final SimulatedRobots team;
    private final Absence absence;
    private final Map<Body, Integer> gone = new HashMap<>(); // how many faults say so

    SimFaults(SimulatedRobots team, Absence absence) {
        this.team = team;
        this.absence = absence;
    }

    @Override
    public Optional<String> refusal(String robot, String device, Fault fault) {
        return team.find(robot)
                .map(broken -> refusal(broken, device, fault))
                .orElseGet(() -> Optional.of("There is no robot '%s'.".formatted(robot)));
    }

    private static Optional<String> refusal(SimRobot broken, String device, Fault fault) {
        if (fault instanceof Fault.Gone) {
            return device.isEmpty()
                    ? Optional.empty()
                    : Optional.of("Only whole robots can be gone, not their devices.");
        }
        Optional<Device> found = device(broken, device);
        if (found.isEmpty()) {
            return Optional.of("It has no device '%s'; it has %s."
                    .formatted(
                            device,
                            broken.robot().devices().stream()
                                    .map(d -> d.info().name())
                                    .collect(Collectors.joining(", "))));
        }
        return switch (fault) {
            case Fault.OfSensor ofSensor -> SensorFaults.refusal(found.get().getClass(), ofSensor);
            case Fault.MotorDead _, Fault.Slip _ ->
                found.get() == broken.drive() ? Optional.empty() : Optional.of("It is not a drive.");
            case Fault.Gone _ -> Optional.empty();
        };
    }

    @Override
    public Subscription begin(String robot, String device, Fault fault, RandomGenerator random) {
        refusal(robot, device, fault).ifPresent(why -> {
            throw new IllegalArgumentException(why);
        });
        SimRobot broken = team.find(robot).orElseThrow();
        return switch (fault) {
            case Fault.OfSensor ofSensor -> begin(broken, device, ofSensor, random);
            case Fault.MotorDead _, Fault.Slip _ -> broken.drive().begin(fault);
            case Fault.Gone(boolean stays) -> leave(broken, stays);
        };
    }

    private static Subscription begin(SimRobot robot, String device, Fault.OfSensor fault, RandomGenerator random) {
        return robot.devices().stream()
                .filter(sensor -> sensor.info().name().equals(device))
                .findFirst()
                .map(sensor -> sensor.begin(fault, random))
                .orElseGet(() -> robot.drive().begin(fault, random));
    }

    private Subscription leave(SimRobot robot, boolean stays) {
        if (gone.merge(robot.body(), 1, Integer::sum) == 1) {
            absence.begin(robot, stays);
        }
        return new Subscription() {
            private boolean cancelled;

            @Override
            public void cancel() {
                if (!cancelled) {
                    cancelled = true;
                    if (gone.merge(robot.body(), -1, Integer::sum) == 0) {
                        absence.end(robot);
                    }
                }
            }
        };
    }

    private static Optional<Device> device(SimRobot robot, String name) {
        return robot.robot().devices().stream()
                .filter(device -> device.info().name().equals(name))
                .findFirst();
    }
}
