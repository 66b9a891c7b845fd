package rsal.testkit.fake;

import java.time.InstantSource;
import org.jspecify.annotations.Nullable;
import rsal.data.BatteryState;
import rsal.data.BatteryState.Charging;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.Battery;
import rsal.device.DeviceInfo;
import rsal.device.SimulationControl.Thing;
import rsal.robot.RobotModel.Part;

/// A battery that loses what its part says, or shows what a test wants. Robots drive on when it is empty.
public final class FakeBattery extends FakeSensor<BatteryState> implements Battery {
    private static final double TOUCH = 0.05; // m

    private final Part.Battery part;
    private final FakeDriveBase base;
    private final FakeWorld world;
    private final InstantSource clock;
    private @Nullable BatteryState shown;
    private double charge;

    FakeBattery(DeviceInfo info, Part.Battery part, FakeDriveBase base, FakeWorld world, InstantSource clock) {
        super(info);
        this.part = part;
        this.base = base;
        this.world = world;
        this.clock = clock;
        this.charge = part.charge();
    }

    /// From now on every reading is this one.
    public void show(BatteryState state) {
        shown = state;
    }

    @Override
    void sense() {
        Twist2d velocity = base.velocity();
        double used = part.idlePower()
                + part.energyPerMeter() * velocity.speed()
                + part.energyPerRadian() * Math.abs(velocity.omega());
        double offered = world.things().stream()
                .filter(this::isTouched)
                .mapToDouble(Thing::givingPower)
                .sum();
        double before = charge;
        double power = Math.min(part.chargingPower(), offered) - used;
        charge = Math.clamp(before + power * FakeSystem.STEP_SECONDS, 0, part.capacity());
        Charging whileOffered = charge == part.capacity() ? Charging.FULL : Charging.CHARGING;
        Charging charging = offered == 0 ? Charging.DISCHARGING : whileOffered;
        BatteryState state = shown != null
                ? shown
                : BatteryState.of(charge, part.capacity(), (charge - before) / FakeSystem.STEP_SECONDS, charging);
        deliver(new Stamped<>(clock.instant(), info().robot() + "/base_link", state));
    }

    private boolean isTouched(Thing thing) {
        Pose2d at = base.mapFromBase();
        return FakeWorld.distance(thing, at.x(), at.y()) < base.radius() + TOUCH;
    }
}
