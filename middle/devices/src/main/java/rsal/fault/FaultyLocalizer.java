package rsal.fault;

import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import java.util.random.RandomGenerator;
import rsal.data.OccupancyGrid;
import rsal.data.ParticleCloud;
import rsal.data.PoseEstimate;
import rsal.data.Stamped;
import rsal.device.Health;
import rsal.device.Localizer;
import rsal.device.SensorCore;
import rsal.device.Subscription;

/// Another localizer, in whose place it stands, and what is wrong with it. The particles are those of the other one.
public final class FaultyLocalizer extends SensorCore<PoseEstimate> implements Localizer {
    private static final Duration PATIENCE = Duration.ofSeconds(1);

    private final Localizer localizer;
    private final SensorFaults<PoseEstimate> faults = new SensorFaults<>();

    public FaultyLocalizer(Localizer localizer) {
        super(localizer.info());
        this.localizer = localizer;
        localizer.latest().ifPresent(this::show);
        localizer.subscribe(this::show);
        localizer.onHealth(this::reported);
    }

    /// The other one, with which nothing is wrong.
    public Localizer inner() {
        return localizer;
    }

    /// Begins a fault.
    ///
    /// @return ends it
    public Subscription begin(Fault.OfSensor fault, RandomGenerator random) {
        return faults.add(fault, random);
    }

    private void show(Stamped<PoseEstimate> reading) {
        faults.shown(reading).ifPresentOrElse(this::deliver, () -> {
            if (latest().filter(last -> reading.time().isBefore(last.time().plus(PATIENCE)))
                    .isEmpty()) {
                health(new Health.Stale("No estimate for %d s.".formatted(PATIENCE.toSeconds())));
            }
        });
    }

    /// While it shows nothing it is not well because the other one is.
    private void reported(Health health) {
        if (!(health.equals(Health.ok()) && faults.areDeadly())) {
            health(health);
        }
    }

    @Override
    public Optional<OccupancyGrid> givenMap() {
        return localizer.givenMap();
    }

    @Override
    public CompletionStage<Void> relocalize(PoseEstimate belief) {
        return localizer.relocalize(belief);
    }

    @Override
    public Optional<Stamped<ParticleCloud>> particles() {
        return localizer.particles();
    }
}
