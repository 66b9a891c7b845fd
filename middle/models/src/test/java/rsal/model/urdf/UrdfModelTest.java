package rsal.model.urdf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.model.RobotModels;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Part;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Problem;

class UrdfModelTest {
    private static final String CART = read("cart.urdf");

    private static String read(String file) {
        try (InputStream in = UrdfModelTest.class.getResourceAsStream(file)) {
            return new String(Objects.requireNonNull(in).readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    private static UrdfModel made(String urdf) {
        return UrdfModel.read(urdf, "cart.urdf", "cart");
    }

    /// As a scenario reads what was made.
    private static RobotModel model(UrdfModel made) {
        FileSource files = (path, _, _) -> Objects.requireNonNull(
                        path.equals("cart.yaml") ? made.model() : made.parts().get(path))
                .getBytes(StandardCharsets.UTF_8);
        return new RobotModels(files, Map.of()).read("cart.yaml", Location.of("cart.yaml"));
    }

    private static double most(RobotModel model, ToDoubleFunction<Point2d> coordinate) {
        return model.footprint().corners().stream()
                .mapToDouble(coordinate)
                .max()
                .orElseThrow();
    }

    @Test
    void theBodyLiesAroundTheMiddleBetweenTheWheels() {
        RobotModel model = model(made(CART));
        assertThat(model.title()).isEqualTo("Cart of a lab");
        assertThat(most(model, Point2d::x)).isCloseTo(0.3, within(1e-3)); // the wheels are 0.1 m behind the middle
        assertThat(most(model, corner -> -corner.x())).isCloseTo(0.1, within(1e-3));
        assertThat(most(model, Point2d::y)).isCloseTo(0.17, within(1e-3)); // outside of the wheels
        assertThat(made(CART).model()).contains("bottom: 0.04, height: 0.12}"); // of the box
    }

    @Test
    void theDriveIsAsFastAsItsWheels() {
        RobotModel.Drive drive = model(made(CART)).drive();
        assertThat(drive.maxSpeed()).isCloseTo(0.5, within(1e-6)); // 10 rad/s, 0.05 m
        assertThat(drive.maxTurnRate()).isCloseTo(2 * 0.5 / 0.32, within(1e-3));
        UrdfModel unknown = made(CART.replace("<limit velocity=\"10\" effort=\"1\"/>", ""));
        assertThat(unknown.notes())
                .extracting(Problem::message)
                .anySatisfy(note -> assertThat(note).contains("does not say how fast"));
        assertThat(model(unknown).drive().maxSpeed()).isEqualTo(0.5);
    }

    @Test
    void itsLaserIsAPartOfItsOwn() {
        UrdfModel made = made(CART);
        assertThat(made.parts()).containsOnlyKeys("cart-laser.yaml");
        var laser = (Part.Laser) Objects.requireNonNull(model(made).sensors().get("laser"));
        assertThat(Math.toDegrees(-2 * laser.angleMin())).isCloseTo(180, within(1e-3));
        assertThat(laser.samples()).isEqualTo(360);
        Pose2d mount = laser.baseFromLaser();
        assertThat(mount.x()).isCloseTo(0.2, within(1e-6));
        assertThat(Math.toDegrees(mount.theta())).isCloseTo(90, within(1e-3));
    }

    @Test
    void whatIsLeftOutIsReported() {
        assertThat(made(CART).notes())
                .extracting(Problem::toString)
                .anySatisfy(note -> assertThat(note).contains("cart.urdf:21:", "not a box, cylinder or sphere"));
        assertThat(made(CART).model()).contains("camera: [0.3, 0, 0, 0.15]");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
            <robot name="x"><link name="a"/>             | This is not XML
            <sdf/>                                        | begins with 'sdf', not 'robot'
            <robot name="x"/>                             | has no 'link'
            <robot><link name="a"/></robot>               | No link has a collision shape
            <robot><link name="a"/><joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint></robot> | Joint 'j' has no link 'b' as its child
            <robot><link name="a"/><link name="b"/><joint name="j"><parent link="a"/><child link="b"/></joint><joint name="k"><parent link="b"/><child link="a"/></joint></robot> | form a circle
            <robot><link name="a"><collision><geometry><box size="1 1"/></geometry></collision></link></robot> | 'size' must be 3 numbers, not '1 1'
            <!DOCTYPE robot [<!ENTITY a SYSTEM "file:///etc/hostname">]><robot name="&a;"><link name="a"/></robot> | This is not XML
            """)
    void saysWhatIsWrong(String urdf, String message) {
        assertThatThrownBy(() -> made(urdf))
                .isInstanceOf(InvalidSettings.class)
                .hasMessageContaining(message)
                .hasMessageContaining("cart.urdf");
    }

    /// What is cut, doubled or changed anywhere gives a model, or an error that is told.
    @Test
    void nonsenseIsReported() {
        for (long seed = 0; seed < (Boolean.getBoolean("rsal.test.all") ? 2000 : 400); seed++) {
            var random = new SplittableRandom(seed);
            var text = new StringBuilder(CART);
            for (int i = random.nextInt(1, 4); i > 0; i--) {
                int at = random.nextInt(text.length() - 20);
                switch (random.nextInt(3)) {
                    case 0 -> text.delete(at, at + random.nextInt(1, 20));
                    case 1 -> text.insert(at, text.substring(at, at + random.nextInt(1, 20)));
                    default -> text.setCharAt(at, "<>\"/ 0-e\u00e4".charAt(random.nextInt(9)));
                }
            }
            try {
                List<Problem> notes = made(text.toString()).notes();
                assertThat(notes).as("seed %d", seed).doesNotContainNull();
            } catch (InvalidSettings e) {
                assertThat(e).as("seed %d", seed).hasMessageNotContaining("null");
            }
        }
    }
}
