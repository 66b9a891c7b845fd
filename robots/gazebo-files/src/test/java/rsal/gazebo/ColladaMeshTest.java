package rsal.gazebo;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

class ColladaMeshTest {
    /// A plate of 2 x 1 at y = 0.7, in cm, and a leg that a node of the library shows twice.
    static final String TABLE = """
            <?xml version="1.0" encoding="utf-8"?>
            <COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
              <asset><unit name="centimeter" meter="0.01"/><up_axis>Y_UP</up_axis></asset>
              <library_geometries>
                <geometry id="plate"><mesh>
                  <source id="plate-positions">
                    <float_array id="p" count="9">-100 0 -50 100 0 50 100 0 -50</float_array>
                    <technique_common><accessor source="#p" count="3" stride="3"/></technique_common>
                  </source>
                  <source id="plate-normals"><float_array id="n" count="3">0 1000 0</float_array></source>
                  <vertices id="v"><input semantic="POSITION" source="#plate-positions"/></vertices>
                </mesh></geometry>
                <geometry id="leg"><mesh>
                  <source id="leg-positions">
                    <float_array id="l" count="9">7 0 0 0 0 70 0 0 1 1 1</float_array>
                    <technique_common><accessor source="#l" count="2" stride="5" offset="1"/></technique_common>
                  </source>
                  <vertices id="w"><input semantic="POSITION" source="#leg-positions"/></vertices>
                </mesh></geometry>
                <geometry id="unused"><mesh>
                  <source id="u"><float_array id="f" count="3">9999 9999 9999</float_array></source>
                  <vertices id="x"><input semantic="POSITION" source="#u"/></vertices>
                </mesh></geometry>
              </library_geometries>
              <library_nodes>
                <node id="foot"><rotate>1 0 0 -90</rotate><instance_geometry url="#leg"/></node>
              </library_nodes>
              <library_visual_scenes><visual_scene id="scene">
                <node><matrix>1 0 0 0  0 1 0 70  0 0 1 0  0 0 0 1</matrix><instance_geometry url="#plate"/></node>
                <node><translate>90 0 0</translate><instance_node url="#foot"/></node>
                <node><translate>-120 0 0</translate><scale>1 1.1 1</scale><instance_node url="#foot"/></node>
              </visual_scene></library_visual_scenes>
              <scene><instance_visual_scene url="#scene"/></scene>
            </COLLADA>
            """;

    private static Optional<MeshBounds> bounds(String mesh) {
        return MeshBounds.of("model://table/Table.DAE", mesh.getBytes(StandardCharsets.UTF_8));
    }

    private static void assertBounds(String mesh, double... lowAndHigh) {
        MeshBounds bounds = bounds(mesh).orElseThrow();
        double[] found = {
            bounds.low().x(), bounds.low().y(), bounds.low().z(),
            bounds.high().x(), bounds.high().y(), bounds.high().z()
        };
        assertThat(found).containsExactly(lowAndHigh, Offset.offset(1e-9));
    }

    @Test
    void whatTheSceneShowsIsInMeters() {
        assertBounds(TABLE, -1.2, 0, -0.5, 1, 0.7, 0.5);
    }

    @Test
    void axesAreThoseOfTheFileAsInGazebo() {
        assertBounds(TABLE.replace("Y_UP", "Z_UP"), -1.2, 0, -0.5, 1, 0.7, 0.5);
    }

    @Test
    void withoutASceneAllGeometriesCount() {
        assertBounds(
                TABLE.replace("instance_visual_scene", "instance_physics_scene"), -1, 0, -0.5, 99.99, 99.99, 99.99);
    }

    @Test
    void skinsAreWhereTheyWereBound() {
        String skin = """
                <library_controllers><controller id="actor"><skin source="#plate">
                  <bind_shape_matrix>0.5 0 0 0  0 0.5 0 10  0 0 0.5 0  0 0 0 1</bind_shape_matrix>
                </skin></controller></library_controllers><library_nodes>""";
        String mesh = TABLE.replace("<library_nodes>", skin)
                .replace("<instance_geometry url=\"#plate\"/>", "<instance_controller url=\"#actor\"/>")
                .replace("<instance_node url=\"#foot\"/>", "");
        assertBounds(mesh, -0.5, 0.8, -0.25, 0.5, 0.8, 0.25);
    }

    @Test
    void filesMayHaveAMarkOfTheirEncoding() {
        for (Charset charset : List.of(StandardCharsets.UTF_8, StandardCharsets.UTF_16BE, StandardCharsets.UTF_16LE)) {
            String marked = "\uFEFF" + TABLE.replace(" encoding=\"utf-8\"", "");
            assertThat(MeshBounds.of("t.dae", marked.getBytes(charset)))
                    .as("%s", charset)
                    .isEqualTo(bounds(TABLE));
        }
    }

    @Test
    void cornersThatAreNotFiniteAreLeftOut() {
        assertBounds(TABLE.replace("100 0 -50</float_array>", "100 INF NaN</float_array>"), -1.2, 0, -0.5, 1, 0.7, 0.5);
    }

    @Test
    @Timeout(20)
    void whatShowsTooMuchHasNoBounds() {
        String loop = "<node id=\"loop\"><instance_node url=\"#loop\"/>";
        assertThat(bounds(TABLE.replace("<node><translate>90", loop + "<translate>90")))
                .isEmpty();
        String many = "<instance_geometry url=\"#plate\"/>".repeat(400_000);
        String large = "1 2 3 ".repeat(100_000);
        assertThat(bounds(TABLE.replace("<instance_geometry url=\"#plate\"/>", many)
                        .replace("-100 0 -50 100 0 50", large)))
                .isEmpty();
    }

    @Test
    void whatIsNoColladaHasNoBounds() {
        assertThat(bounds("<svg/>")).isEmpty();
        assertThat(bounds("solid")).isEmpty();
        assertThat(bounds(TABLE.replace("-100 0 -50", "a lot"))).isEmpty();
    }
}
