package rsal.sim;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import rsal.data.LightState;
import rsal.data.LightState.Signal;
import rsal.data.Rgb;
import rsal.device.DeviceInfo;
import rsal.device.Light;
import rsal.robot.RobotModel.Part;

/// A simulated light. No other device sees whether it shines.
final class SimLight extends SimActuatedDevice<LightState> implements Light {
    private final InstantSource clock;
    private final Rgb color;
    private Signal signal;
    private Instant since;

    SimLight(DeviceInfo info, Part.Light part, InstantSource clock) {
        super(info, info.id(), part.period());
        this.clock = clock;
        this.color = part.color();
        this.signal = part.signal();
        this.since = clock.instant();
    }

    @Override
    public void show(Signal next) {
        signal = next;
        since = clock.instant();
    }

    @Override
    void work(Instant now, double dt) {
        if (isDue(now)) {
            take(new LightState(color, signal, signal.litAfter(Duration.between(since, now))), now);
        }
    }
}
