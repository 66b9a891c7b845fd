package rsal.gazebo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import org.junit.jupiter.api.Test;
import rsal.robot.RobotModel.Drive;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotModel.Steering;
import rsal.robot.RobotSpec;
import rsal.scene.Scene;

class SdfRobotsTest {
    /// A cart whose wheels are 0.3 m behind the model's origin.
    private static String cart(String more, String plugin) {
        return """
                <model name="cart"><pose>2 1 0.1 0 0 1.5707963267948966</pose>
                <link name="chassis"><collision name="c"><geometry><box><size>1 0.5 0.1</size></box></geometry></collision>
                  <visual name="c"><geometry><box><size>1 0.5 0.1</size></box></geometry>
                  <material><diffuse>0 0 1 1</diffuse></material></visual>%s</link>
                <link name="left"><pose>-0.3 0.25 0 -1.5707963267948966 0 0</pose><collision name="c"><geometry>
                  <cylinder><radius>0.1</radius><length>0.04</length></cylinder></geometry></collision></link>
                <link name="right"><pose>-0.3 -0.25 0 -1.5707963267948966 0 0</pose><collision name="c"><geometry>
                  <cylinder><radius>0.1</radius><length>0.04</length></cylinder></geometry></collision></link>
                <joint name="lj" type="revolute"><parent>chassis</parent><child>left</child></joint>
                <joint name="rj" type="revolute"><parent>chassis</parent><child>right</child></joint>
                %s</model>
                """.formatted(more, plugin);
    }

    private static final String DIFFERENTIAL = """
            <plugin filename="libignition-gazebo-diff-drive-system.so" name="ignition::gazebo::systems::DiffDrive">
            <left_joint>lj</left_joint><right_joint>rj</right_joint>
            <max_linear_velocity>0.8</max_linear_velocity><min_linear_velocity>-0.2</min_linear_velocity>
            <max_angular_velocity>2</max_angular_velocity><max_linear_acceleration>1.5</max_linear_acceleration></plugin>
            """;

    private static final String LASER = """
            <sensor name="front" type="gpu_lidar"><pose>0.4 0 0.2 0 0 0.1</pose><update_rate>20</update_rate><lidar><scan>
            <horizontal><samples>181</samples><min_angle>-1.5707963</min_angle><max_angle>1.5707963</max_angle></horizontal>
            </scan><range><min>0.05</min><max>8</max></range><noise><type>gaussian</type><stddev>0.02</stddev></noise></lidar>
            </sensor>""";

    private static RobotSpec robot(String content) {
        return Worlds.of(content).read().robots().getFirst();
    }

    @Test
    void aModelWithTwoDrivenWheelsIsARobot() {
        Scene scene = Worlds.of(cart(LASER, DIFFERENTIAL)).read();
        assertThat(scene.things()).isEmpty();
        assertThat(scene.warnings()).isEmpty();
        RobotSpec robot = scene.robots().getFirst();
        assertThat(robot.id()).isEqualTo("cart");
        assertThat(robot.color()).isEqualTo("#0000ff");
        // between its wheels: 0.3 m behind the model's origin
        assertThat(robot.mapFromBase().orElseThrow().x()).isCloseTo(2, within(1e-9));
        assertThat(robot.mapFromBase().orElseThrow().y()).isCloseTo(0.7, within(1e-9));
        assertThat(robot.model().footprint().corners())
                .anySatisfy(corner -> assertThat(corner.x()).isCloseTo(0.8, within(1e-9)));
        assertThat(robot.model().body().pieces())
                .anySatisfy(piece -> assertThat(piece.bottom()).isCloseTo(0.05, within(1e-9)))
                .allSatisfy(piece -> assertThat(piece.bottom()).isGreaterThanOrEqualTo(0));
        Drive drive = robot.model().drive();
        assertThat(drive.steering()).isEqualTo(new Steering.Differential());
        assertThat(drive.forward().speed().least()).isEqualTo(-0.2);
        assertThat(drive.maxSpeed()).isEqualTo(0.8);
        assertThat(drive.maxTurnRate()).isEqualTo(2);
        assertThat(drive.maxAcceleration()).isEqualTo(1.5);
    }

    @Test
    void itsLasersAreWhereTheyAre() {
        RobotSpec robot = robot(cart(LASER, DIFFERENTIAL));
        var laser = (Part.Laser) robot.model().sensors().get("laser");
        assertThat(laser).isNotNull();
        assertThat(laser.baseFromLaser().x()).isCloseTo(0.7, within(1e-9));
        assertThat(laser.baseFromLaser().theta()).isCloseTo(0.1, within(1e-9));
        assertThat(robot.model().heights().get("laser")).isCloseTo(0.3, within(1e-9));
        assertThat(laser.samples()).isEqualTo(181);
        assertThat(laser.angleMin() + 180 * laser.angleIncrement()).isCloseTo(1.5707963, within(1e-9));
        assertThat(laser.rangeMax()).isEqualTo(8);
        assertThat(laser.noise().deviation()).isEqualTo(0.02);
        assertThat(laser.period()).isEqualTo(Duration.ofMillis(50));
    }

    @Test
    void aLaserUpsideDownLooksTheOtherWayRound() {
        String turned = LASER.replace("0.4 0 0.2 0 0 0.1", "0 0 0 3.141592653589793 0 0")
                .replace("<max_angle>1.5707963", "<max_angle>0.5");
        var laser =
                (Part.Laser) robot(cart(turned, DIFFERENTIAL)).model().sensors().get("laser");
        assertThat(laser).isNotNull();
        assertThat(laser.angleMin()).isEqualTo(-0.5);
    }

    @Test
    void whatIsNotGivenIsGuessedAndReported() {
        var worlds = Worlds.of(cart(
                "<sensor name='c' type='camera'/>",
                "<plugin filename='gz-sim-velocity-control-system' name='gz::sim::systems::VelocityControl'/>"));
        assertThat(worlds.notes())
                .containsExactly(
                        "Model 'cart' tells no speeds: 0.5 m/s and 90 degrees/s are guessed.",
                        "A sensor of type 'camera' is left out.");
        assertThat(worlds.read().robots().getFirst().model().drive().steering())
                .isEqualTo(new Steering.Omnidirectional());
    }

    @Test
    void modelsThatDriveOtherwiseAreThings() {
        var worlds = Worlds.of(cart("", "<plugin filename='gz-sim-ackermann-steering-system' name='A'/>"));
        assertThat(worlds.read().things()).hasSize(1);
        assertThat(worlds.notes())
                .containsExactly("Model 'cart' drives in a way that is not known here, and is a thing.");
        assertThat(Worlds.of(cart(LASER, "")).notes())
                .containsExactly("Model 'cart' has a laser and no drive, and is a thing.");
    }

    @Test
    void copiesAreOfOneMake() {
        Scene scene = Worlds.of("""
                        <include><uri>model://cart</uri><name>a/1</name></include>
                        <include><uri>model://cart</uri><name>b</name><pose>9 9 0.6 0 0 0</pose></include>""")
                .and("worlds/cart/model.sdf", "<sdf version='1.9'>" + cart("", DIFFERENTIAL) + "</sdf>")
                .read();
        assertThat(scene.robots()).extracting(RobotSpec::id).containsExactly("a.1", "b");
        assertThat(scene.robots()).extracting(RobotSpec::role).containsExactly("cart", "cart");
        assertThat(scene.robotBodies()).containsOnlyKeys("b"); // the other one stands on the floor
        assertThat(scene.robotBodies().get("b"))
                .satisfies(body -> assertThat(body.height()).isCloseTo(0.5, within(1e-9)));
    }

    @Test
    void aRobotInAThingIsReported() {
        assertThat(Worlds.of(cart("", DIFFERENTIAL)
                                + Worlds.model("box", "<pose>2 1 0 0 0 0</pose>", "<box><size>1 1 1</size></box>"))
                        .notes())
                .containsExactly("Robot 'cart' starts inside 'box'.");
    }
}
