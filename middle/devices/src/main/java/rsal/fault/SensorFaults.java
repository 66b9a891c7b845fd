package rsal.fault;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.random.RandomGenerator;
import org.jspecify.annotations.Nullable;
import rsal.data.Perturbable;
import rsal.data.Stamped;
import rsal.device.Battery;
import rsal.device.BlobFinder;
import rsal.device.Bumper;
import rsal.device.Device;
import rsal.device.DriveBase;
import rsal.device.FiducialFinder;
import rsal.device.LaserScanner;
import rsal.device.Localizer;
import rsal.device.SonarArray;
import rsal.device.Subscription;
import rsal.robot.DeviceKind;
import rsal.robot.DeviceKinds;

/// What is wrong with one sensor now, between what it measures and what it shows. For those who make sensors.
public final class SensorFaults<T> {
    private static final List<Class<? extends Device>> RANGES = List.of(LaserScanner.class, SonarArray.class);
    private static final List<Class<? extends Device>> PLACES =
            List.of(BlobFinder.class, FiducialFinder.class, DriveBase.class, Localizer.class);
    private static final List<Class<? extends Device>> STATES = List.of(Bumper.class, Battery.class);

    private final List<Active> active = new ArrayList<>();
    private @Nullable T shown; // last

    /// One that was begun is no other, however alike.
    private static final class Active {
        private final Fault.OfSensor fault;
        private final RandomGenerator random;

        Active(Fault.OfSensor fault, RandomGenerator random) {
            this.fault = fault;
            this.random = random;
        }
    }

    /// Why a kind of device can't have a fault, in a sentence; empty when it can.
    ///
    /// @param type the contract that it fulfils
    public static Optional<String> refusal(Class<? extends Device> type, Fault.OfSensor fault) {
        Optional<DeviceKind> registered = DeviceKinds.of(type);
        if (registered.isPresent()) {
            return refusal(registered.get(), fault);
        }
        if (!isOf(RANGES, type) && !isOf(PLACES, type) && !isOf(STATES, type)) {
            return Optional.of("It is not a sensor.");
        }
        boolean error = fault instanceof Fault.Biased || fault instanceof Fault.Noisy;
        if (error && isOf(STATES, type)) {
            return Optional.of("It measures no ranges, so that it can only be dead or frozen.");
        }
        double angle =
                fault instanceof Fault.Biased(double _, double a) ? a : fault instanceof Fault.Noisy n ? n.angle() : 0;
        if (angle != 0 && isOf(RANGES, type)) {
            return Optional.of("It measures ranges only, so that there is no error of its angles.");
        }
        return Optional.empty();
    }

    private static Optional<String> refusal(DeviceKind kind, Fault.OfSensor fault) {
        boolean error = fault instanceof Fault.Biased || fault instanceof Fault.Noisy;
        return error && !Perturbable.class.isAssignableFrom(kind.reads())
                ? Optional.of("No errors can be added to its readings, so that it can only be dead or frozen.")
                : Optional.empty();
    }

    private static boolean isOf(List<Class<? extends Device>> contracts, Class<? extends Device> type) {
        return contracts.stream().anyMatch(contract -> contract.isAssignableFrom(type));
    }

    /// Begins a fault. Errors add up, in the order in which they began.
    ///
    /// @param random a stream of this fault's own
    /// @return ends it
    public Subscription add(Fault.OfSensor fault, RandomGenerator random) {
        var begun = new Active(fault, random);
        active.add(begun);
        return () -> active.remove(begun);
    }

    /// What the sensor shows when it takes a reading; empty when it shows nothing.
    public Optional<Stamped<T>> shown(Stamped<T> reading) {
        if (active.isEmpty()) {
            shown = reading.value();
            return Optional.of(reading);
        }
        if (areDeadly()) {
            return Optional.empty();
        }
        T before = shown;
        T now = before != null && isAny(Fault.Frozen.class) ? before : wrong(reading.value());
        shown = now;
        return Optional.of(new Stamped<>(reading.time(), reading.frame(), now));
    }

    /// Whether the sensor shows nothing now.
    boolean areDeadly() {
        return isAny(Fault.Dead.class);
    }

    private boolean isAny(Class<? extends Fault.OfSensor> kind) {
        return active.stream().anyMatch(each -> kind.isInstance(each.fault));
    }

    private T wrong(T right) {
        T wrong = right;
        for (Active each : active) {
            wrong = wrong(each, wrong);
        }
        return wrong;
    }

    private static <T> T wrong(Active active, T value) {
        return switch (active.fault) {
            case Fault.Dead _, Fault.Frozen _ -> value;
            case Fault.Biased bias -> ReadingErrors.reading(value, ReadingErrors.Miss.of(bias));
            case Fault.Noisy noise -> ReadingErrors.reading(value, ReadingErrors.Miss.of(noise, active.random));
        };
    }
}
