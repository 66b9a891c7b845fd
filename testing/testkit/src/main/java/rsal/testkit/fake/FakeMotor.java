package rsal.testkit.fake;

/// Something that moves to where it should be, at a constant speed.
final class FakeMotor {
    private final double speed;
    private double position;
    private double target;

    /// @param speed per second
    FakeMotor(double position, double speed) {
        this.position = position;
        this.target = position;
        this.speed = speed;
    }

    void goTo(double place) {
        target = place;
    }

    void stop() {
        target = position;
    }

    void step() {
        double most = speed * FakeSystem.STEP_SECONDS;
        position = Math.clamp(target, position - most, position + most);
    }

    double position() {
        return position;
    }

    boolean arrived() {
        return position == target;
    }

    /// 1 towards larger positions, -1 towards smaller ones, 0 when it stands.
    double direction() {
        return Math.signum(target - position);
    }
}
