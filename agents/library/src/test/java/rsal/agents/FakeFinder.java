package rsal.agents;

import java.time.Instant;
import java.util.List;
import java.util.OptionalInt;
import rsal.data.Fiducials;
import rsal.data.Fiducials.Fiducial;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.device.DeviceInfo;
import rsal.device.FiducialFinder;
import rsal.device.SensorCore;

/// Sees what a test shows it.
public final class FakeFinder extends SensorCore<Fiducials> implements FiducialFinder {
    public FakeFinder(String robot) {
        super(new DeviceInfo(robot, "fiducials", "fake"));
    }

    public void sees(OptionalInt id, double ahead, double left, Instant now) {
        publish(List.of(new Fiducial(id, new Pose2d(ahead, left, 0))), now);
    }

    public void seesNothing(Instant now) {
        publish(List.of(), now);
    }

    private void publish(List<Fiducial> fiducials, Instant now) {
        var reading = new Fiducials(Pose2d.ORIGIN, Math.PI, 8, fiducials);
        deliver(new Stamped<>(now, info().robot() + "/base_link", reading));
    }
}
