package rsal.engine.world;

import java.util.List;
import java.util.Optional;
import rsal.data.Fan;
import rsal.data.Stamped;
import rsal.device.RangeSensor;
import rsal.device.Sensor;
import rsal.device.SensorCore;

/// A real robot's range sensor, in whose place it stands, that sees what is simulated, too.
abstract class OverlaidSensor<T> extends SensorCore<T> implements RangeSensor {
    private final RangeSensor real;
    private final Overlay overlay;

    <S extends Sensor<T> & RangeSensor> OverlaidSensor(S real, Overlay overlay) {
        super(real.info());
        this.real = real;
        this.overlay = overlay;
        real.latest().ifPresent(this::show);
        health(real.health());
        real.subscribe(this::show);
        real.onHealth(this::health);
    }

    /// The sensor in whose place it stands.
    final RangeSensor real() {
        return real;
    }

    private void show(Stamped<T> reading) {
        T value = reading.value();
        List<Fan> fans = fans(value);
        Optional<double[]> simulated = overlay.ranges(fans, info().name(), reach(value), reading.time());
        deliver(simulated
                .map(ranges -> new Stamped<>(reading.time(), reading.frame(), nearest(value, fans, ranges)))
                .orElse(reading));
    }

    /// The rays of a reading.
    abstract List<Fan> fans(T reading);

    /// How far it sees [m].
    abstract double reach(T reading);

    /// A reading with what is nearest, be it real or simulated.
    ///
    /// @param simulated way of each ray of the fans [m]; +∞ for one that meets nothing
    abstract T nearest(T real, List<Fan> fans, double[] simulated);
}
