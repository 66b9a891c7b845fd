package rsal.server.live;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.time.Duration;
import java.util.List;
import rsal.engine.SpeedFactor;
import rsal.engine.report.RunEvent;
import rsal.server.frame.Feed;
import rsal.server.frame.FrameEncoder;
import rsal.server.frame.Moment;
import rsal.server.frame.ObjectRegistry;
import rsal.server.history.Past;
import rsal.server.message.Messages.LookBack;
import rsal.server.message.Refusal;

/// One viewer's way through the past of a run: where it is, and how fast it goes on. For one thread.
public final class PlaybackCursor implements Feed {
    private static final double FASTEST = 1000; // times real time, which is what `max` is here

    private final Past past;
    private final int looks;
    private Duration time; // since the run's start
    private boolean playing;
    private double speed;
    private Moment moment;
    private byte[] frame = {};
    private long sequence;
    private String details = "";
    private long detailsVersion;

    /// From the beginning on.
    public PlaybackCursor(Past past) {
        this(past, past.from(), true, 1, 1);
    }

    private PlaybackCursor(Past past, Duration time, boolean playing, double speed, int looks) {
        this.past = past;
        this.looks = looks;
        this.time = time;
        this.playing = playing;
        this.speed = speed;
        this.moment = past.at(time);
        show();
    }

    /// @param from where the viewer is
    /// @param looks how often it has looked elsewhere
    /// @throws Refusal when nobody can be that fast
    public static PlaybackCursor at(Past past, LookBack wish, Duration from, int looks) {
        double seconds = wish.time().orElse(from.toNanos() / 1e9);
        Duration wanted = Double.isFinite(seconds) ? Past.time(seconds) : past.until();
        int step = wish.step().orElse(0);
        Duration there = step == 0 ? clamp(past, wanted) : past.near(wanted, step);
        double speed =
                Math.clamp(Refusal.unless(() -> SpeedFactor.parse(wish.speed().orElse("1"))), 0.1, FASTEST);
        boolean ends = past.isRecording() && there.compareTo(past.until()) >= 0;
        boolean goesOn = wish.time().isEmpty() && (step == 0 || step == 1);
        return new PlaybackCursor(
                past, there, wish.playing().orElse(false) && !ends, speed, goesOn ? looks : looks + 1);
    }

    private static Duration clamp(Past past, Duration time) {
        if (time.compareTo(past.from()) < 0) {
            return past.from();
        }
        return time.compareTo(past.until()) > 0 ? past.until() : time;
    }

    /// Goes on, if it plays.
    public void pass(Duration realTime) {
        if (!playing) {
            return;
        }
        time = clamp(past, time.plusNanos((long) (realTime.toNanos() * speed)));
        playing = !hasArrived() || !past.isRecording();
        if (!past.near(time, 0).equals(moment.time())) {
            moment = past.at(time);
            show();
        } else if (!playing) {
            show();
        }
    }

    /// Whether it has played up to the newest moment there is.
    boolean hasArrived() {
        return time.compareTo(past.until()) >= 0;
    }

    boolean isPlaying() {
        return playing;
    }

    Past past() {
        return past;
    }

    public Duration time() {
        return time;
    }

    /// How often the viewer has looked elsewhere, so far.
    int looks() {
        return looks;
    }

    /// The moment's frame, but for what depends on the viewer.
    private void show() {
        if (!moment.details().equals(details)) {
            details = moment.details();
            detailsVersion++;
        }
        frame = moment.frame().clone();
        ByteBuffer header = ByteBuffer.wrap(frame).order(ByteOrder.LITTLE_ENDIAN);
        int flags = (header.getInt(FrameEncoder.FLAGS_AT) & ~FrameEncoder.PAUSED)
                | FrameEncoder.PAST
                | looks << FrameEncoder.LOOKS_AT;
        header.putInt(FrameEncoder.SEQUENCE_AT, (int) ++sequence);
        header.putInt(FrameEncoder.FLAGS_AT, playing ? flags : flags | FrameEncoder.PAUSED);
        header.putFloat(FrameEncoder.SPEED_AT, (float) speed);
        header.putFloat(FrameEncoder.RATE_AT, playing ? (float) speed : 0);
    }

    @Override
    public int number() {
        return past.number();
    }

    @Override
    public String info() {
        return past.info();
    }

    @Override
    public int robots() {
        return past.robots();
    }

    @Override
    public String newcomers(int known) {
        return past.newcomers(known);
    }

    @Override
    public ObjectRegistry things() {
        return moment.things();
    }

    @Override
    public long detailsVersion() {
        return detailsVersion;
    }

    /// All of them: moments that one jumps between have little in common.
    @Override
    public String details(long known) {
        return details;
    }

    @Override
    public byte[] frame() {
        return frame;
    }

    @Override
    public long sequence() {
        return sequence;
    }

    @Override
    public List<RunEvent> events(long after) {
        return past.events(after);
    }
}
