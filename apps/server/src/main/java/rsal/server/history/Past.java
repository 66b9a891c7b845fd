package rsal.server.history;

import io.javalin.http.Context;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import rsal.engine.report.RunEvent;
import rsal.server.frame.Moment;
import rsal.server.message.Refusal;

/// What has been of a run: moments to look back on. For one thread.
public interface Past {
    /// Before a time that is looked at: for as long, what agents say all the time is told.
    Duration SHORTLY = Duration.ofSeconds(10);

    /// Of the run, from 1.
    int number();

    /// The run's [rsal.server.message.Messages.RunInfo] as JSON.
    String info();

    /// How many robots the run has or had.
    int robots();

    /// The [rsal.server.message.Messages.Newcomers] as JSON.
    ///
    /// @param known how many robots the viewer knows
    String newcomers(int known);

    /// When the first moment was that there still is, since the run's start.
    Duration from();

    /// When the newest moment was.
    Duration until();

    /// Whether there will never be a newer one, nor a run to go back to.
    boolean isRecording();

    /// The newest moment by then; the first when there is none.
    Moment at(Duration time);

    /// When the moment was that is so many after the newest by a time, or before it.
    Duration near(Duration time, int after);

    /// A time as viewers tell it, which is not exact: to the nearest ns, and at most 32 years.
    ///
    /// @param seconds since the run's start; no number is 0
    static Duration time(double seconds) {
        return Duration.ofNanos(Math.round(Math.clamp(seconds, -1e9, 1e9) * 1e9));
    }

    /// The time that is asked about, in s of the run; the end when none is.
    ///
    /// @throws Refusal when it is not a number
    static Duration asked(Context request) {
        String typed = Optional.ofNullable(request.queryParam("time")).orElse("1e9");
        double seconds;
        try {
            seconds = Double.parseDouble(typed);
        } catch (NumberFormatException _) {
            seconds = Double.NaN;
        }
        if (!Double.isFinite(seconds)) {
            throw new Refusal(400, "A time is a number of seconds, not '%s'.".formatted(Refusal.shortened(typed)));
        }
        return time(seconds);
    }

    /// The time that is asked about, in s of the run; empty when none is, which is about the present.
    ///
    /// @throws Refusal when it is not a number
    static Optional<Duration> askedBack(Context request) {
        return Optional.ofNullable(request.queryParam("time")).map(_ -> asked(request));
    }

    /// What has happened after an event, oldest first; the future, too.
    ///
    /// @param sequence of that event; 0 for all
    List<RunEvent> events(long sequence);
}
