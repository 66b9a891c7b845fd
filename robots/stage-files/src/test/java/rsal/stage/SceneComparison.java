package rsal.stage;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.assertj.core.api.recursive.comparison.RecursiveComparisonConfiguration;
import rsal.data.Angles;
import rsal.data.Pose2d;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotSpec;
import rsal.scene.Entity;
import rsal.scene.Scene;

/// Whether two scenes are the same but for rounding, and for the numbers behind the names of models and parts.
final class SceneComparison {
    private static final double TINY = 1e-9;

    private SceneComparison() {}

    static void assertSame(Scene actual, Scene expected) {
        assertThat(actual.title()).isEqualTo(expected.title());
        assertThat(actual.step()).isEqualTo(expected.step());
        assertThat(actual.touch()).isEqualTo(expected.touch());
        assertThat(actual.end()).isEqualTo(expected.end());
        assertThat(actual.walls()).isEqualTo(expected.walls()); // bit for bit
        assertClose("things", actual.things(), expected.things());
        assertThat(actual.robots()).extracting(RobotSpec::id).isEqualTo(ids(expected));
        Map<RobotModel, RobotModel> same = new HashMap<>();
        for (int i = 0; i < expected.robots().size(); i++) {
            RobotSpec a = actual.robots().get(i);
            RobotSpec e = expected.robots().get(i);
            assertThat(a.role()).as(e.id()).isEqualTo(e.role());
            assertThat(a.color()).as(e.id()).isEqualTo(e.color());
            assertClose(e.id(), a.mapFromBase().orElseThrow(), e.mapFromBase().orElseThrow());
            if (same.put(e.model(), a.model()) == null) {
                assertSame(e.id(), a.model(), e.model());
            }
            Entity body = actual.robotBodies().get(e.id());
            Entity expectedBody = expected.robotBodies().get(e.id());
            assertThat(body).as(e.id()).isNotNull();
            assertThat(expectedBody).as(e.id()).isNotNull();
            assertClose(e.id(), List.of(body), List.of(expectedBody));
        }
        assertThat(actual.odomFromBase().keySet())
                .isEqualTo(expected.odomFromBase().keySet());
        expected.odomFromBase()
                .forEach((id, pose) -> assertClose(id, actual.odomFromBase().get(id), pose));
        assertThat(actual.programs()).isEqualTo(expected.programs());
        assertThat(actual.map().cells()).isEqualTo(expected.map().cells());
    }

    private static List<String> ids(Scene scene) {
        return scene.robots().stream().map(RobotSpec::id).toList();
    }

    private static void assertSame(String which, RobotModel actual, RobotModel expected) {
        assertThat(plain(actual.name())).as(which).isEqualTo(plain(expected.name()));
        assertThat(actual.title()).as(which).isEqualTo(expected.title());
        assertClose(which, actual.body(), expected.body());
        assertClose(which, actual.drive(), expected.drive());
        assertThat(List.copyOf(actual.sensors().keySet()))
                .as(which)
                .isEqualTo(List.copyOf(expected.sensors().keySet()));
        expected.sensors().forEach((device, part) -> {
            Part read = actual.sensors().get(device);
            assertThat(read).as(device).isNotNull();
            assertThat(plain(read.name())).isEqualTo(plain(part.name()));
            assertClose(which + "/" + device, read, part);
        });
        assertClose(which, actual.heights(), expected.heights());
        assertThat(actual.carriers()).as(which).isEqualTo(expected.carriers());
    }

    private static String plain(String name) {
        return name.replaceFirst("-\\d+$", "");
    }

    private static void assertClose(String which, Object actual, Object expected) {
        var how = new RecursiveComparisonConfiguration();
        how.registerComparatorForType(
                (a, b) -> Math.abs(a - b) <= TINY * Math.max(1, Math.abs(a)) ? 0 : 1, Double.class);
        how.registerComparatorForType(SceneComparison::difference, Pose2d.class);
        how.ignoreFields("name"); // of parts and models
        assertThat(actual).as(which).usingRecursiveComparison(how).isEqualTo(expected);
    }

    private static int difference(Pose2d a, Pose2d b) {
        return a.distanceTo(b) <= TINY && Math.abs(Angles.difference(a.theta(), b.theta())) <= TINY ? 0 : 1;
    }
}
