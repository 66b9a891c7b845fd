package rsal.player.bridge;

import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import rsal.data.Stamped;
import rsal.device.Sensor;
import rsal.device.Subscription;
import rsal.player.message.Interface;
import rsal.player.wire.MalformedException;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;
import rsal.time.Scheduler;

/// A device that tells what it measures.
abstract class OfferedSensor<T> extends Offered {
    private static final Duration PATIENCE = Duration.ofSeconds(4); // clients have 5

    private final Sensor<T> sensor;

    OfferedSensor(Interface interf, int index, Sensor<T> sensor, Scheduler scheduler) {
        super(interf, index, sensor.info(), scheduler);
        this.sensor = sensor;
    }

    /// It does once it has measured something: nobody knows before how it is built.
    @Override
    final CompletionStage<Boolean> starts() {
        return sensor.latest().isPresent()
                ? CompletableFuture.completedStage(true)
                : scheduler().within(PATIENCE, sensor.next()).handle((_, error) -> error == null);
    }

    @Override
    Subscription listen() {
        return sensor.subscribe(this::publish);
    }

    /// Publishes a reading.
    abstract void publish(Stamped<T> reading);

    /// Nothing, before it has measured once.
    @Override
    Optional<Answer> answer(Packet request) throws MalformedException {
        int subtype = request.header().subtype();
        return sensor.latest()
                .filter(_ -> understands(MessageKind.REQUEST, subtype))
                .map(reading -> new Answer.Reported(body(reading.value(), subtype)));
    }

    /// What it answers to a request that it understands, by its newest reading.
    Record body(T newest, int subtype) {
        throw new IllegalArgumentException("Request '%d' is not known.".formatted(subtype));
    }
}
