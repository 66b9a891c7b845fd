package rsal.recording.animation;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleConsumer;
import rsal.recording.Playback;

/// A recorded run as an animated GIF: the map from above, robots in their colors with what their lasers see, the paths
/// that they mean to take and those that they came along.
public final class RunAnimation {
    private static final int MOST_FRAMES = 2_000;
    private static final int LOOKED_AT = 12; // frames, for their colors
    private static final Duration LAST_FRAME = Duration.ofSeconds(2); // longer, so that the end is seen

    private final Playback playback;
    private final Settings settings;
    private final List<Duration> times;

    /// @param longest side of the picture [px], from 100 to 4000
    /// @param speed simulated over real time, when it is played
    /// @param framesPerSecond when it is played, from 1 to 50
    /// @param from since the run's start
    /// @param until the same; when it is later than the end of the recording, that
    public record Settings(int longest, double speed, double framesPerSecond, Duration from, Duration until) {
        public Settings {
            if (longest < 100 || longest > 4000) {
                throw new IllegalArgumentException(
                        "The longest side must be from 100 to 4000 pixels, not '%d'.".formatted(longest));
            }
            if (!(speed > 0 && Double.isFinite(speed))) {
                throw new IllegalArgumentException("The speed must be more than 0, not '%s'.".formatted(speed));
            }
            if (!(framesPerSecond >= 1 && framesPerSecond <= 50)) {
                throw new IllegalArgumentException(
                        "There must be from 1 to 50 frames a second, not '%s'.".formatted(framesPerSecond));
            }
            if (until.compareTo(from) <= 0) {
                throw new IllegalArgumentException("The end (%s s) must be after the beginning (%s s)."
                        .formatted(until.toMillis() / 1e3, from.toMillis() / 1e3));
            }
        }
    }

    /// @throws IllegalArgumentException when nothing was recorded in that time, or there were more than 2,000 frames
    public RunAnimation(Playback playback, Settings settings) {
        this.playback = playback;
        this.settings = settings;
        Duration end = settings.until().compareTo(playback.until()) < 0 ? settings.until() : playback.until();
        Duration begin = settings.from().compareTo(playback.from()) > 0 ? settings.from() : playback.from();
        if (end.compareTo(begin) <= 0) {
            throw new IllegalArgumentException(
                    "Nothing was recorded in that time: the recording is from %.1f s to %.1f s."
                            .formatted(
                                    playback.from().toMillis() / 1e3,
                                    playback.until().toMillis() / 1e3));
        }
        double step = settings.speed() / settings.framesPerSecond(); // of simulated time [s]
        double count = Math.ceil((end.toMillis() - begin.toMillis()) / 1e3 / step);
        if (count >= MOST_FRAMES) {
            throw new IllegalArgumentException(
                    "These are %.0f frames, more than %d. Choose a higher speed, fewer frames a second, or less of the run."
                            .formatted(count, MOST_FRAMES));
        }
        this.times = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            times.add(begin.plusMillis(Math.round(1e3 * i * step)));
        }
        times.add(end);
    }

    /// How many pictures it has.
    public int frames() {
        return times.size();
    }

    /// Draws it.
    ///
    /// @param progress told now and then how much is done, up to 1
    /// @throws IOException when the recording can't be read, or Java can't draw here
    public byte[] gif(DoubleConsumer progress) throws IOException {
        var painter = new RunPainter(playback, settings.longest());
        var palette = new Palette();
        for (int i = 0; i < LOOKED_AT; i++) {
            palette.count(painter.paint(times.get(i * (times.size() - 1) / (LOOKED_AT - 1))));
        }
        painter.forget();
        try (var gif = new GifWriter(palette.model())) {
            for (int i = 0; i < times.size(); i++) {
                BufferedImage frame = painter.paint(times.get(i));
                gif.add(frame, i == times.size() - 1 ? LAST_FRAME : shown());
                progress.accept((i + 1.0) / times.size());
            }
            return gif.bytes();
        }
    }

    private Duration shown() {
        return Duration.ofMillis(Math.round(1e3 / settings.framesPerSecond()));
    }
}
