package rsal.testkit.fake;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import rsal.data.LightState;
import rsal.data.LightState.Signal;
import rsal.data.Stamped;
import rsal.device.DeviceInfo;
import rsal.device.Light;
import rsal.robot.RobotModel.Part;

/// A light that remembers every signal.
public final class FakeLight extends FakeSensor<LightState> implements Light {
    private final Part.Light part;
    private final InstantSource clock;
    private final List<Signal> signals = new ArrayList<>();
    private Signal signal;
    private Instant since;

    FakeLight(DeviceInfo info, Part.Light part, InstantSource clock) {
        super(info);
        this.part = part;
        this.clock = clock;
        this.signal = part.signal();
        this.since = clock.instant();
    }

    /// All signals it was told to show, the oldest first.
    public List<Signal> signals() {
        return List.copyOf(signals);
    }

    @Override
    public void show(Signal next) {
        signals.add(next);
        signal = next;
        since = clock.instant();
    }

    @Override
    void sense() {
        Instant now = clock.instant();
        boolean lit = signal.litAfter(Duration.between(since, now));
        deliver(new Stamped<>(now, info().id(), new LightState(part.color(), signal, lit)));
    }
}
