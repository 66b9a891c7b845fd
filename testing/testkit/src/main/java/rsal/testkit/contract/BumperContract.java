package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;
import rsal.data.BumperState;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.Bumper;
import rsal.robot.RobotModel.Part;

/// What every [Bumper] owes.
public abstract class BumperContract extends SensorContract<BumperState, Bumper> {
    protected BumperContract() {
        super(Bumper.class, "r1/base_link");
    }

    @Override
    protected Map<String, String> parts() {
        return Map.of("bumper", "pioneer2dx-bumpers");
    }

    private Part.Bumper part() {
        return (Part.Bumper) java.util.Objects.requireNonNull(model().sensors().get("bumper"));
    }

    @Test
    void itsReadingsAreThoseOfTheModelsBumpers() {
        assertThat(reading().baseFromBumpers())
                .isEqualTo(
                        part().pads().stream().map(Part.Bumper.Pad::baseFromPad).toList());
    }

    @Test
    void inTheOpenNothingIsPressed() {
        assertThat(reading().any()).isFalse();
        drive(Twist2d.drive(0.3, 0.5), 2);
        assertThat(reading().any()).isFalse();
    }

    @Test
    void aWallPressesTheBumpersThatFaceItUntilTheRobotBacksOff() {
        needs(Capability.TRUTH);
        needs(Capability.WALLS);
        simulation()
                .place(
                        "r1",
                        new Pose2d(WORLD.place('w').x() - 1, WORLD.place('w').y(), 0));
        drive(Twist2d.drive(0.3, 0), 6);
        BumperState touching = device().latest().orElseThrow().value();
        assertThat(touching.any()).isTrue();
        for (int i = 0; i < touching.pressed().size(); i++) {
            double heading = Math.abs(touching.baseFromBumpers().get(i).theta());
            assertThat(touching.pressed().get(i) && heading > Math.toRadians(100))
                    .as("bumper %d at the back", i)
                    .isFalse();
        }
        drive(Twist2d.drive(-0.3, 0), 3);
        assertThat(reading().any()).isFalse();
    }
}
