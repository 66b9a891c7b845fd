package rsal.stage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.data.Twist2d;
import rsal.stage.ModelKind.Drive;
import rsal.stage.ModelKind.Limits;
import rsal.stage.ModelKind.Localization;
import rsal.stage.ModelKind.OdometryError;
import rsal.stage.ModelKind.RangeNoise;
import rsal.stage.ModelKind.Strip;
import rsal.stage.ModelKind.Transducer;

/// What models of each type can do.
class ModelKindTest {
    private static final double RIGHT = Math.PI / 2;

    @Test
    void aPositionHasStagesDefaults() {
        var one = new ValueRange(-1, 1);
        var limits = new Limits(one, one, one, new ValueRange(-RIGHT, RIGHT));
        assertThat(kind("position ( )"))
                .isEqualTo(new ModelKind.Position(
                        Drive.DIFFERENTIAL,
                        1,
                        Twist2d.STOP,
                        limits,
                        limits,
                        Localization.GPS,
                        Optional.empty(),
                        Optional.empty()));
    }

    @Test
    void aPositionHasWhatItSays() {
        var position = (ModelKind.Position) kind("""
                position ( drive "car" wheelbase 0.3 velocity [0.1 0.2 0 90] localization "odom"
                           velocity_bounds [-0.1 0.5 -0.2 0.6 0 0 -45 90]
                           acceleration_bounds [-1 2 -3 4 -5 6 -180 180]
                           localization_origin [1 2 0 90] odom_error [0.05 0.06 0.07 0.1] )
                """);
        assertThat(position.drive()).isEqualTo(Drive.CAR);
        assertThat(position.wheelbase()).isEqualTo(0.3);
        assertThat(position.velocity()).isEqualTo(new Twist2d(0.1, 0.2, RIGHT));
        assertThat(position.localization()).isEqualTo(Localization.ODOMETRY);
        assertThat(position.speeds())
                .isEqualTo(new Limits(
                        new ValueRange(-0.1, 0.5),
                        new ValueRange(-0.2, 0.6),
                        new ValueRange(0, 0),
                        new ValueRange(-RIGHT / 2, RIGHT)));
        assertThat(position.accelerations().z()).isEqualTo(new ValueRange(-5, 6));
        assertThat(position.odometryOrigin()).contains(Placement.of(1, 2, 0, RIGHT));
        assertThat(position.odometryError()).contains(new OdometryError(0.05, 0.06, 0.07, 0.1));
        assertThat(((ModelKind.Position) kind("position ( drive \"omni\" )")).drive())
                .isEqualTo(Drive.OMNIDIRECTIONAL);
    }

    @Test
    void aRangerHasATransducerForEachSensor() {
        assertThat(((ModelKind.Ranger) kind("ranger ( )")).transducers()).isEmpty();
        assertThat(((ModelKind.Ranger) kind("ranger ( sensor ( ) )")).transducers())
                .containsExactly(new Transducer(
                        Placement.ORIGIN, new Size(0.02, 0.02, 0.02), new ValueRange(0, 5), 0.1, 1, RangeNoise.NONE));
    }

    @Test
    void aLaserSpreadsItsRaysFromRightToLeft() {
        var laser = ((ModelKind.Ranger) kind("""
                define eye sensor ( range [0.1 8] fov 180 samples 181 noise [0.01 0.02 90] )
                ranger ( eye ( pose [0.1 0 0.2 90] size [0.1 0.1 0.1] color "green" ) )
                """)).transducers().getFirst();
        assertThat(laser)
                .isEqualTo(new Transducer(
                        Placement.of(0.1, 0, 0.2, RIGHT),
                        new Size(0.1, 0.1, 0.1),
                        new ValueRange(0.1, 8),
                        Math.PI,
                        181,
                        new RangeNoise(0.01, 0.02, RIGHT)));
        assertThat(laser.first()).isEqualTo(-RIGHT);
        assertThat(laser.spacing()).isCloseTo(Math.toRadians(1), within(1e-12));
    }

    @Test
    void aSingleRayGoesStraightAhead() {
        var sonar = ((ModelKind.Ranger) kind("ranger ( sensor ( fov 30 ) )"))
                .transducers()
                .getFirst();
        assertThat(sonar.first()).isZero();
        assertThat(sonar.spacing()).isZero();
    }

    @Test
    void aBlobfinderLooksForColors() {
        assertThat(kind("blobfinder ( )"))
                .isEqualTo(new ModelKind.Blobfinder(List.of(), 80, 60, 12, Math.toRadians(60), 0));
        assertThat(kind("""
                        blobfinder ( colors_count 2 colors ["red" "blue" "green"] image [160 120] range 5 fov 90 pan -45 )
                        """))
                .isEqualTo(new ModelKind.Blobfinder(
                        List.of(StageColor.RED, StageColor.BLUE), 160, 120, 5, RIGHT, Math.toRadians(-45)));
        assertThat(((ModelKind.Blobfinder) kind("blobfinder ( colors [\"red\" \"blue\"] )")).colors())
                .hasSize(2);
    }

    @Test
    void aFiducialFinderSeesMarkersOfItsKey() {
        assertThat(kind("fiducial ( )")).isEqualTo(new ModelKind.Fiducial(new ValueRange(0, 8), 5, Math.PI, 0, false));
        assertThat(kind("fiducial ( range_min 1 range_max 9 range_max_id 2 fov 90 fiducial_key 4 ignore_zloc 1 )"))
                .isEqualTo(new ModelKind.Fiducial(new ValueRange(1, 9), 2, RIGHT, 4, true));
    }

    @Test
    void aGripperHasPaddlesAndABack() {
        Traits gripper = Worlds.of("gripper ( )").model().traits();
        assertThat(gripper.size()).isEqualTo(new Size(0.2, 0.3, 0.2));
        assertThat(gripper.color()).contains(new StageColor(190, 190, 190, 255));
        assertThat(gripper.kind())
                .isEqualTo(new ModelKind.Gripper(new Size(0.66 * 0.2, 0.1 * 0.3, 0.4 * 0.2), false, false, false));
        assertThat(gripper.body().prisms())
                .singleElement()
                .satisfies(back -> assertThat(back.outline())
                        .allSatisfy(corner -> assertThat(corner.x()).isBetween(-0.1, 0.1 - 0.66 * 0.2)));
        assertThat(
                        kind(
                                "gripper ( size [1 1 1] paddle_size [0.5 0.2 0.3] paddle_state [\"closed\" \"up\"] autosnatch 1 )"))
                .isEqualTo(new ModelKind.Gripper(new Size(0.5, 0.2, 0.3), true, true, true));
    }

    @Test
    void aBumperHasStrips() {
        assertThat(kind("bumper ( bcount 2 blength 0.3 bpose[0] [0.1 0 0 90] bpose[1] [0.2 0 0 0] blength[1] 0.5 )"))
                .isEqualTo(new ModelKind.Bumper(List.of(
                        new Strip(Placement.of(0.1, 0, 0, RIGHT), 0.3), new Strip(Placement.of(0.2, 0, 0, 0), 0.5))));
    }

    @Test
    void anActuatorMovesAlongOrAroundAnAxis() {
        assertThat(kind("actuator ( )")).isEqualTo(new ModelKind.Actuator(false, 1, 0, 0, new ValueRange(0, 1), 1, 0));
        assertThat(kind("actuator ( axis [0 0 2] min_position -1 max_position 3 max_speed 0.5 start_position 0.2 )"))
                .isEqualTo(new ModelKind.Actuator(false, 0, 0, 1, new ValueRange(-1, 3), 0.5, 0.2));
        var arm = (ModelKind.Actuator) kind(
                "actuator ( type \"rotational\" min_position -90 max_position 90 max_speed 180 start_position 45 )");
        assertThat(arm.turning()).isTrue();
        assertThat(arm.positions()).isEqualTo(new ValueRange(-RIGHT, RIGHT));
        assertThat(arm.maxSpeed()).isEqualTo(Math.PI);
        assertThat(arm.start()).isEqualTo(RIGHT / 2);
    }

    @Test
    void aCameraIsKept() {
        assertThat(kind("camera ( )"))
                .isEqualTo(new ModelKind.Camera(
                        32, 32, new ValueRange(0.2, 8), Math.toRadians(70), Math.toRadians(40), 0, 0));
        assertThat(kind("camera ( resolution [100 50] range [1 2] fov [90 45] pantilt [90 -45] )"))
                .isEqualTo(new ModelKind.Camera(100, 50, new ValueRange(1, 2), RIGHT, RIGHT / 2, RIGHT, -RIGHT / 2));
    }

    @Test
    void lampsAndLightsAreKept() {
        assertThat(kind("blinkenlight ( )")).isEqualTo(new ModelKind.Blinkenlight(Duration.ofSeconds(1), 1, true));
        assertThat(kind("blinkenlight ( period 250 dutycycle 0.5 enabled 0 )"))
                .isEqualTo(new ModelKind.Blinkenlight(Duration.ofMillis(250), 0.5, false));
        assertThat(kind("lightindicator ( )")).isEqualTo(new ModelKind.LightIndicator());
        assertThat(Worlds.of("blinkenlight ( )").model().traits().size()).isEqualTo(new Size(0.02, 0.02, 0.02));
    }

    private static ModelKind kind(String text) {
        return Worlds.of(text).model().traits().kind();
    }
}
