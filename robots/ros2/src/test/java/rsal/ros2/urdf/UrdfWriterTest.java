package rsal.ros2.urdf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import rsal.data.ActuatorState.Joint;
import rsal.data.Interval;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Prism;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.model.RobotModels;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Part;
import rsal.ros2.message.FrameTransform;

class UrdfWriterTest {
    private static final Pose2d LIFT = new Pose2d(0.2, 0.1, Math.PI / 2);

    private static List<RobotModel> models() {
        return RobotModels.readBuiltIn();
    }

    private static Document parse(String urdf) throws Exception {
        return DocumentBuilderFactory.newInstance()
                .newDocumentBuilder()
                .parse(new ByteArrayInputStream(urdf.getBytes(StandardCharsets.UTF_8)));
    }

    private static List<Element> all(Document urdf, String tag) {
        var nodes = urdf.getElementsByTagName(tag);
        return IntStream.range(0, nodes.getLength())
                .mapToObj(i -> (Element) nodes.item(i))
                .toList();
    }

    private static Element within1(Element element, String tag) {
        return (Element) element.getElementsByTagName(tag).item(0);
    }

    private static List<String> links(Document urdf, String tag) {
        return all(urdf, tag).stream().map(each -> each.getAttribute("link")).toList();
    }

    /// What URDF asks for: one link without a parent, all others with one that exists.
    @ParameterizedTest
    @MethodSource("models")
    void linksFormATree(RobotModel model) throws Exception {
        Document urdf = parse(UrdfWriter.urdf("r1", model));
        List<String> links = all(urdf, "link").stream()
                .map(each -> each.getAttribute("name"))
                .toList();
        assertThat(urdf.getDocumentElement().getAttribute("name")).isEqualTo("r1");
        assertThat(links).doesNotHaveDuplicates().startsWith("base_link");
        assertThat(links(urdf, "child")).containsExactlyElementsOf(links.subList(1, links.size()));
        assertThat(links).containsAll(links(urdf, "parent"));
        assertThat(all(urdf, "collision")).hasSameSizeAs(model.body().pieces());
    }

    private static RobotModel model(Prism piece, Map<String, Part> parts, Map<String, String> carriers) {
        RobotModel any = models().getFirst();
        return new RobotModel(
                "own",
                "Own",
                new Solid(List.of(piece)),
                any.drive(),
                parts,
                Map.of("lift", 0.3, "table", 0.5),
                carriers);
    }

    private static Part.Actuator actuator(String name, Pose2d there, Joint joint, double slope, double home) {
        return new Part.Actuator(
                name, there, joint, slope, new Interval(-1, 2), 0.5, home, java.time.Duration.ofMillis(100));
    }

    private static Map<String, Part> parts() {
        var parts = new LinkedHashMap<String, Part>();
        parts.put("lift", actuator("small-lift", LIFT, Joint.LINEAR, Math.PI / 2, 0.25));
        parts.put("table", actuator("small-table", new Pose2d(0.2, 0.4, 0), Joint.ROTATIONAL, 0, 0));
        return parts;
    }

    @Test
    void turnedRectanglesAreBoxes() throws Exception {
        var diamond =
                new Shape.Polygon(List.of(new Point2d(1, 0), new Point2d(2, 1), new Point2d(1, 2), new Point2d(0, 1)));
        var piece = new Prism(diamond, 0.1, 0.3, Optional.of(new Rgb(255, 0, 51)));
        String urdf = UrdfWriter.urdf("a<b", model(piece, Map.of(), Map.of()));
        assertThat(urdf)
                .contains("<robot name=\"a&lt;b\">")
                .contains("<box size=\"1.4142 1.4142 0.2000\"/>")
                .contains("<origin xyz=\"1.0000 1.0000 0.2000\" rpy=\"0 0 0.7854\"/>")
                .contains("rgba=\"1.000 0.000 0.200 1\"");
        var triangle = new Shape.Polygon(List.of(new Point2d(0, 0), new Point2d(3, 0), new Point2d(0, 1)));
        assertThat(UrdfWriter.urdf("r", model(Prism.standing(triangle, 1), Map.of(), Map.of())))
                .contains("<box size=\"3.0000 1.0000 1.0000\"/>");
    }

    /// Where joints are by the description is where frames are published.
    @Test
    void jointsMoveWhatTheyCarry() throws Exception {
        RobotModel model =
                model(Prism.standing(new Shape.Disc(new Point2d(0, 0), 0.2), 0.2), parts(), Map.of("table", "lift"));
        Document urdf = parse(UrdfWriter.urdf("r1", model));
        List<Element> joints = all(urdf, "joint");
        assertThat(joints).extracting(each -> each.getAttribute("type")).containsExactly("prismatic", "revolute");
        assertThat(links(urdf, "parent")).containsExactly("base_link", "lift");
        assertThat(within1(joints.getFirst(), "origin").getAttribute("xyz")).isEqualTo("0.2000 0.1000 0.0500");
        assertThat(within1(joints.getFirst(), "axis").getAttribute("xyz")).isEqualTo("0.0000 0 1.0000");
        assertThat(within1(joints.getFirst(), "limit").getAttribute("upper")).isEqualTo("2.0000");
        FrameTransform up = UrdfWriter.moved(model, "lift", (Part.Actuator) parts().get("lift"), 1.25);
        assertThat(up.z()).isCloseTo(1.3, within(1e-9));
        assertThat(up.planar().isNear(LIFT, 1e-9, 1e-9)).isTrue();
        FrameTransform turned = UrdfWriter.moved(model, "table", (Part.Actuator) parts().get("table"), 0.5);
        FrameTransform baseFromTable = UrdfWriter.moved(model, "lift", (Part.Actuator) parts().get("lift"), 0.25)
                .compose(turned);
        assertThat(baseFromTable.planar().isNear(new Pose2d(0.2, 0.4, 0.5), 1e-9, 1e-9))
                .isTrue();
        assertThat(baseFromTable.z()).isCloseTo(0.5, within(1e-9));
    }

    @Test
    void sensorsAreAtTheirHeights() {
        RobotModel model = models().stream()
                .filter(each -> each.name().equals("turtlebot3-burger"))
                .findFirst()
                .orElseThrow();
        var found = new ArrayList<String>(model.sensors().keySet());
        assertThat(found).isNotEmpty();
        FrameTransform laser = UrdfWriter.mounting(model, "laser", new Pose2d(-0.03, 0, 0));
        assertThat(laser.z()).isEqualTo(model.height("laser"));
        assertThat(UrdfWriter.mounting(model, "sonar_3", Pose2d.ORIGIN).z()).isEqualTo(model.height("sonar"));
    }

    /// The left one is at positive y. A wheel that turns forward takes its top ahead and its front down.
    @Test
    void wheelsAreBesideTheBaseAndTurnForward() {
        var wheels = new RobotModel.Wheels(0.1, 0.4);
        FrameTransform left = UrdfWriter.wheel(wheels, UrdfWriter.LEFT_WHEEL, Math.PI / 2);
        assertThat(left.y()).isEqualTo(0.2);
        assertThat(left.z()).isEqualTo(0.1);
        assertThat(UrdfWriter.wheel(wheels, UrdfWriter.RIGHT_WHEEL, 0).y()).isEqualTo(-0.2);
        double[] top = left.rotation().rotated(0, 0, 0.1);
        assertThat(top[0]).isCloseTo(0.1, within(1e-9));
        double[] front = left.rotation().rotated(0.1, 0, 0);
        assertThat(front[2]).isCloseTo(-0.1, within(1e-9));
    }
}
