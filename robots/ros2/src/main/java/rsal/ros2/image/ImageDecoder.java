package rsal.ros2.image;

import java.time.Duration;
import java.time.Instant;
import java.util.function.Consumer;
import rsal.time.Scheduler;

/// Decodes compressed images beside the run's thread, which they would hold up: one of 1920 × 1080 pixels takes 50 ms.
/// One is decoded at a time; those that come meanwhile are left out. All calls on the run's thread.
public final class ImageDecoder {
    private static final Duration PERIOD = Duration.ofMillis(95); // from one to the next at least

    private final Scheduler scheduler;
    private final Duration period;
    private Instant begun = Instant.MIN; // the newest
    private boolean isBusy;

    private sealed interface Decoded {
        record Image(ImageMessage image) implements Decoded {}

        record Damaged(String why) implements Decoded {}
    }

    /// Reads an image.
    public interface Reading {
        ImageMessage read() throws CompressedImage.Unreadable;
    }

    private ImageDecoder(Scheduler scheduler, Duration period) {
        this.scheduler = scheduler;
        this.period = period;
    }

    /// Ten a second at most; others are left out, too.
    public static ImageDecoder ofTenASecond(Scheduler scheduler) {
        return new ImageDecoder(scheduler, PERIOD);
    }

    /// As fast as it can.
    public static ImageDecoder ofAll(Scheduler scheduler) {
        return new ImageDecoder(scheduler, Duration.ZERO);
    }

    /// @param reading reads data that are not changed any more, on another thread
    /// @param onImage gets the image
    /// @param onDamage gets why there is none
    public void decode(Reading reading, Consumer<ImageMessage> onImage, Consumer<String> onDamage) {
        Instant now = scheduler.instant();
        if (isBusy || begun.plus(period).isAfter(now)) {
            return;
        }
        begun = now;
        isBusy = true;
        scheduler.compute(() -> decoded(reading)).thenAccept(result -> {
            isBusy = false;
            switch (result) {
                case Decoded.Image(ImageMessage image) -> onImage.accept(image);
                case Decoded.Damaged(String why) -> onDamage.accept(why);
            }
        });
    }

    private static Decoded decoded(Reading reading) {
        try {
            return new Decoded.Image(reading.read());
        } catch (CompressedImage.Unreadable e) {
            return new Decoded.Damaged(String.valueOf(e.getMessage()));
        }
    }
}
