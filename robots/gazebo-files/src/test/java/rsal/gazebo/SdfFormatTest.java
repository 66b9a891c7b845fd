package rsal.gazebo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import org.junit.jupiter.api.Test;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Prism;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.scene.Entity;
import rsal.scene.Scene;

class SdfFormatTest {
    private static final String BOX = "<box><size>2 1 0.5</size></box>";

    private static Prism only(Entity thing) {
        assertThat(thing.blocks()).hasSize(1);
        return thing.blocks().getFirst().prism();
    }

    @Test
    void aBoxStandsWhereItsModelIs() {
        Entity box = Worlds.of(Worlds.model("box", "<static>1</static><pose>3 2 0.25 0 0 1.5707963</pose>", BOX))
                .thing("box");
        Prism prism = only(box);
        assertThat(prism.bottom() + box.height()).isCloseTo(0, within(1e-9));
        assertThat(prism.top() + box.height()).isCloseTo(0.5, within(1e-9));
        assertThat(Worlds.covers(box, 3.4, 2.9)).isTrue(); // turned: 1 m along x, 2 m along y
        assertThat(Worlds.covers(box, 3.6, 2)).isFalse();
        assertThat(box.blocks().getFirst().surface().obstacle()).isTrue();
    }

    @Test
    void roundShapesAreDiscsAndReachAsHighAsTheyDo() {
        var worlds = Worlds.of(Worlds.model(
                        "can",
                        "<pose>1 0 0.5 0 0 0</pose>",
                        "<cylinder><radius>0.2</radius><length>1</length></cylinder>")
                + Worlds.model("ball", "<pose>0 1 0.3 0 0 0</pose>", "<sphere><radius>0.3</radius></sphere>")
                + Worlds.model(
                        "pill", "<pose>0 0 1 0 0 0</pose>", "<capsule><radius>0.1</radius><length>1</length></capsule>")
                + Worlds.model("egg", "<pose>0 0 1 0 0 0</pose>", "<ellipsoid><radii>0.1 0.1 0.4</radii></ellipsoid>"));
        for (String name : new String[] {"can", "ball", "pill", "egg"}) {
            assertThat(only(worlds.thing(name)).shape()).isInstanceOf(Shape.Disc.class);
        }
        assertThat(only(worlds.thing("can")).top()).isEqualTo(0.5);
        assertThat(only(worlds.thing("ball")).bottom()).isEqualTo(-0.3);
        assertThat(only(worlds.thing("pill")).top()).isEqualTo(0.6);
        assertThat(only(worlds.thing("egg")).top()).isEqualTo(0.4);
        assertThat(worlds.notes()).isEmpty();
    }

    @Test
    void whatIsTiltedIsTakenForItsShadow() {
        var worlds = Worlds.of(Worlds.model(
                        "log",
                        "<pose>0 0 0.2 0 1.5707963 0</pose>",
                        "<cylinder><radius>0.2</radius><length>3</length></cylinder>")
                + Worlds.model("ramp", "<pose>9 0 0 0 0.5 0</pose>", BOX));
        Entity log = worlds.thing("log");
        assertThat(Worlds.covers(log, 1.4, 0.15)).isTrue();
        assertThat(Worlds.covers(log, 1.6, 0)).isFalse();
        assertThat(only(log).top()).isCloseTo(0.2, within(1e-6));
        assertThat(worlds.notes())
                .containsExactly(
                        "A shape of kind 'box' is tilted: what it covers, seen from above, is taken to be solid.");
    }

    @Test
    void aBoxOnItsSideIsNotTilted() {
        var worlds = Worlds.of(Worlds.model("box", "<pose>0 0 0 1.5707963267948966 0 0</pose>", BOX));
        assertThat(worlds.notes()).isEmpty();
        assertThat(only(worlds.thing("box")).top()).isCloseTo(0.5, within(1e-9)); // 1 m wide
    }

    @Test
    void anOutlineReachesUp() {
        var worlds = Worlds.of(Worlds.model("l", "<pose>1 1 0 0 0 0</pose>", """
                <polyline><height>2</height><point>0 0</point><point>2 0</point><point>2 1</point><point>1 1</point>
                <point>1 2</point><point>0 2</point><point>0 0</point></polyline>"""));
        Entity outline = worlds.thing("l");
        assertThat(only(outline).top()).isEqualTo(2);
        assertThat(Worlds.covers(outline, 2.5, 1.5)).isTrue();
        assertThat(Worlds.covers(outline, 2.5, 2.5)).isFalse();
    }

    @Test
    void anOutlineThatCrossesItselfIsLeftOut() {
        assertThat(Worlds.of(Worlds.model("x", "", """
                        <polyline><height>1</height><point>0 0</point><point>1 1</point><point>1 0</point><point>0 1</point>
                        </polyline>""")).notes())
                .singleElement()
                .asString()
                .startsWith("A polyline is left out. The edge");
    }

    @Test
    void framesAreRelativeToEachOther() {
        var worlds = Worlds.of("""
                <frame name="gate"><pose>10 0 0 0 0 1.5707963267948966</pose></frame>
                <model name="a"><pose relative_to="gate">1 0 0 0 0 0</pose>
                  <frame name="tip" attached_to="arm"><pose>1 0 0 0 0 0</pose></frame>
                  <link name="arm"><pose relative_to="base">2 0 0 0 0 0</pose></link>
                  <link name="base"><pose degrees="true">0 1 0 0 0 90</pose>
                    <collision name="c"><pose relative_to="tip">0 0 0.5 0 0 0</pose><geometry>
                      <box><size>0.2 0.2 1</size></box></geometry></collision></link>
                </model>
                <model name="b"><pose relative_to="a::tip" rotation_format="quat_xyzw">0 0 0 0 0 1 0</pose>
                  <link name="l"><collision name="c"><geometry><sphere><radius>0.1</radius></sphere></geometry></collision></link>
                </model>
                """);
        // a: at (10, 1), x along the world's y. base: 1 m left of it, at (9, 1), x along the world's −x. arm: 2 m on,
        // at (7, 1). tip: at (6, 1).
        Entity a = worlds.thing("a");
        assertThat(Worlds.covers(a, 6.05, 1.05)).isTrue();
        assertThat(Worlds.covers(a, 6.15, 1)).isFalse();
        assertThat(worlds.thing("b").mapFromEntity().x()).isCloseTo(6, within(1e-9));
        assertThat(worlds.thing("b").mapFromEntity().theta()).isCloseTo(0, within(1e-9)); // turned by 180° twice
    }

    @Test
    void aFrameInACircleIsAnError() {
        assertThat(Worlds.of("""
                        <frame name="a"><pose relative_to="b"/></frame><frame name="b" attached_to="a"/>
                        <model name="m"><pose relative_to="a">0 0 0 0 0 0</pose></model>""").error()).isEqualTo("Frame 'a' is relative to itself, or to too many others.");
        assertThat(Worlds.of("<model name=\"m\"><pose relative_to=\"c\">0 0 0 0 0 0</pose></model>")
                        .error())
                .isEqualTo("There is no frame 'c' here.");
    }

    private static final String TABLE = """
            <sdf version="1.7"><model name="table"><static>true</static><pose>0 0 9 0 0 0</pose>
            <frame name="corner"><pose>1 0 0 0 0 0</pose></frame>
            <link name="top"><collision name="c"><geometry><box><size>2 1 0.1</size></box></geometry></collision></link>
            </model></sdf>""";

    @Test
    void modelsAreIncluded() {
        var worlds = Worlds.of("""
                        <include><uri>model://table</uri><pose>5 0 1 0 0 0</pose></include>
                        <include><uri>model://table</uri><name>second</name><pose>0 5 1 0 0 0</pose>
                          <placement_frame>corner</placement_frame></include>
                        <include><uri>table/model.sdf</uri></include>
                        <model name="group"><pose>0 0 2 0 0 0</pose>
                          <include><uri>model://table</uri><name>inner</name><pose>0 -7 0 0 0 0</pose></include>
                        </model>
                        <model name="beside"><pose relative_to="group::inner::corner">0 0 0 0 0 0</pose><link name="l">
                          <collision name="c"><geometry><sphere><radius>1</radius></sphere></geometry></collision></link></model>
                        """)
                .and("models/table/model.config", "<model><name>Table</name><sdf version='1.7'>t.sdf</sdf></model>")
                .and("models/table/t.sdf", TABLE)
                .and("worlds/table/model.sdf", TABLE);
        assertThat(worlds.read().things())
                .extracting(Entity::name)
                .containsExactly("table", "second", "table_1", "group", "beside");
        assertThat(worlds.thing("table").mapFromEntity()).isEqualTo(Worlds.pose(5, 0, 0));
        assertThat(worlds.thing("table").height()).isEqualTo(1);
        assertThat(worlds.thing("second").mapFromEntity()).isEqualTo(Worlds.pose(-1, 5, 0));
        assertThat(worlds.thing("table_1").height()).isEqualTo(9);
        assertThat(Worlds.covers(worlds.thing("group"), 0.9, -7.4)).isTrue();
        assertThat(worlds.thing("beside").mapFromEntity()).isEqualTo(Worlds.pose(1, -7, 0));
    }

    @Test
    void whatIsNotFoundOrFarIsLeftOut() {
        var worlds = Worlds.of("""
                <include><uri>model://ground_plane</uri></include>
                <include><uri>https://fuel.gazebosim.org/1.0/OpenRobotics/models/Chair</uri></include>
                <include><uri>https://fuel.gazebosim.org/1.0/OpenRobotics/models/Sun</uri></include>
                <include><uri>model://chair</uri></include>
                <include><uri>model://robot.urdf</uri></include>
                """).and("worlds/robot.urdf", "<robot name='r'/>");
        assertThat(worlds.notes())
                .containsExactly(
                        "'https://fuel.gazebosim.org/1.0/OpenRobotics/models/Chair' is left out: nothing is fetched from a"
                                + " network.",
                        "'model://chair' is left out: it is not found.",
                        "'model://robot.urdf' is left out: it holds no model in SDF.");
    }

    @Test
    void aModelThatIncludesItselfIsAnError() {
        assertThat(Worlds.of("<include><uri>model://m</uri></include>")
                        .and("worlds/m/model.sdf", """
                                <sdf version='1.7'><model name='m'><include><uri>model://m</uri></include></model></sdf>""")
                        .error())
                .isEqualTo("Models are nested deeper than 16.");
    }

    @Test
    void meshesAreTheBoxesAroundThem() {
        ByteBuffer stl =
                ByteBuffer.allocate(84 + 50).order(ByteOrder.LITTLE_ENDIAN).putInt(80, 1);
        float[] corners = {-1, 0, 0, 3, 1, 0, 0, 0.5f, 2};
        for (int i = 0; i < corners.length; i++) {
            stl.putFloat(84 + 12 + 4 * i, corners[i]);
        }
        var worlds = Worlds.of(Worlds.model("binary", "", "<mesh><uri>model://m/a.stl</uri><scale>2 1 1</scale></mesh>")
                        + Worlds.model("text", "", "<mesh><uri>b.STL</uri></mesh>")
                        + Worlds.model("obj", "", "<mesh><uri>file://c.obj</uri></mesh>")
                        + Worlds.model("part", "", "<mesh><uri>c.obj</uri><submesh><name>p</name></submesh></mesh>")
                        + Worlds.model("glb", "", "<mesh><uri>d.glb</uri></mesh>"))
                .and("worlds/m/a.stl", stl.array())
                .and(
                        "worlds/b.STL",
                        "solid b\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 1\n")
                .and("worlds/c.obj", "# c\nv 0 0 0\nv 4 1 1\nvn 9 9 9\n");
        Entity binary = worlds.thing("binary");
        assertThat(Worlds.covers(binary, 5.9, 0.9)).isTrue();
        assertThat(Worlds.covers(binary, -1.9, 0.1)).isTrue();
        assertThat(Worlds.covers(binary, -2.1, 0.1)).isFalse();
        assertThat(only(binary).top()).isEqualTo(2);
        assertThat(Worlds.covers(worlds.thing("text"), 0.9, 0.9)).isTrue();
        assertThat(Worlds.covers(worlds.thing("obj"), 3.9, 0.9)).isTrue();
        assertThat(worlds.notes())
                .containsExactly(
                        "Mesh 'model://m/a.stl' is taken for the box around it. So are 2 more.",
                        "A part ('submesh') of mesh 'c.obj' is left out.",
                        "Mesh 'd.glb' is left out: it is not found, or not STL, OBJ or COLLADA.");
    }

    @Test
    void mapsShowWhatIsStatic() {
        Scene scene = Worlds.of(Worlds.model("wall", "<static>true</static><pose>2 0 0 0 0 0</pose>", BOX)
                        + Worlds.model("crate", "<pose>-2 0 0 0 0 0</pose>", BOX))
                .read();
        OccupancyGrid map = scene.map();
        assertThat(map.cells()[map.row(0) * map.width() + map.column(2)]).isEqualTo(OccupancyGrid.OCCUPIED);
        assertThat(map.cells()[map.row(0) * map.width() + map.column(-2)]).isEqualTo(OccupancyGrid.FREE);
        assertThat(scene.title()).isEqualTo("yard");
    }

    @Test
    void whatIsOnlySeenIsInNobodysWay() {
        Entity ghost = Worlds.of("""
                <model name="ghost"><link name="l"><visual name="v"><geometry><sphere><radius>1</radius></sphere></geometry>
                  <material><diffuse>1 0 0 1</diffuse></material></visual></link></model>""").thing("ghost");
        assertThat(ghost.blocks().getFirst().surface().obstacle()).isFalse();
        assertThat(ghost.blocks().getFirst().surface().seenByRangers()).isTrue();
        assertThat(ghost.blocks().getFirst().surface().color()).isEqualTo(new Rgb(255, 0, 0));
    }

    @Test
    void colorsAreThoseOfVisuals() {
        Entity thing = Worlds.of("""
                <model name="m"><link name="l">
                <collision name="a"><geometry><sphere><radius>1</radius></sphere></geometry></collision>
                <collision name="b"><geometry><sphere><radius>2</radius></sphere></geometry></collision>
                <visual name="b"><geometry><sphere><radius>2</radius></sphere></geometry>
                  <material><ambient>0 1 0 1</ambient></material></visual>
                <visual name="a"><geometry><sphere><radius>1</radius></sphere></geometry>
                  <material><script><name>Gazebo/Blue</name></script></material></visual>
                </link></model>""").thing("m");
        assertThat(thing.blocks())
                .extracting(block -> block.surface().color())
                .containsExactly(new Rgb(0, 0, 255), new Rgb(0, 255, 0));
    }

    @Test
    void floorsAreNoThings() {
        Scene scene = Worlds.of(Worlds.model("floor", "", "<plane><normal>0 0 1</normal></plane>")
                        + Worlds.model("ceiling", "<pose>0 0 3 0 0 0</pose>", "<plane><normal>0 0 -1</normal></plane>")
                        + Worlds.model("wall", "", "<plane><normal>1 0 0</normal></plane>")
                        + Worlds.model("hills", "", "<heightmap><uri>h.png</uri></heightmap>")
                        + "<actor name='walker'/><actor name='other'/><light name='sun' type='directional'/>")
                .read();
        assertThat(scene.things()).isEmpty();
        assertThat(scene.warnings())
                .extracting(note -> note.message())
                .containsExactly(
                        "A plane at the height 3.00 m is left out: the floor is at 0.",
                        "A plane that is not level is left out.",
                        "A shape of kind 'heightmap' is left out.",
                        "An actor, which walks by itself, is left out. So is 1 more.");
    }

    @Test
    void errorsSayWhereTheyAre() {
        assertThat(Worlds.of(Worlds.model("m", "<pose>1 2 3</pose>", BOX)).error())
                .isEqualTo("'pose' must be 6 numbers, not '1 2 3'.");
        assertThat(Worlds.of(Worlds.model("m", "", "<box><size>1 1 -1</size></box>"))
                        .error())
                .isEqualTo("'size' must be from 0 to 100000 m, not -1.0.");
        assertThat(Worlds.of(Worlds.model("m", "", "<sphere/>")).error()).isEqualTo("This 'sphere' has no 'radius'.");
        assertThat(Worlds.of("")
                        .and("worlds/test.sdf", "<sdf version='1.9'><model name='m'/></sdf>")
                        .error())
                .isEqualTo("There is no 'world' in this file.");
        assertThat(Worlds.of("").and("worlds/test.sdf", "<robot/>").error())
                .isEqualTo("This is not a world of Gazebo: it begins with 'robot', not 'sdf'.");
        assertThat(Worlds.of("<model name='a'>").error()).startsWith("This is not XML: ");
    }

    @Test
    void declarationsAreNotFollowed() {
        assertThat(Worlds.of("").and("worlds/test.sdf", """
                        <?xml version="1.0"?><!DOCTYPE sdf [<!ENTITY a SYSTEM "file:///etc/passwd">]>
                        <sdf version="1.9"><world name="&a;"/></sdf>""").error()).startsWith("This is not XML: ");
    }

    @Test
    void worldsOfGazeboAreKnownByWhatIsInThem() {
        var format = new SdfFormat(Map.of());
        assertThat(format.suffix()).isEqualTo(".sdf");
        assertThat(format.sharedSuffixes()).containsExactly(".world");
        assertThat(format.recognizes("\uFEFF \n<?xml version='1.0'?>".getBytes(StandardCharsets.UTF_8)))
                .isTrue();
        assertThat(format.recognizes("# a world\nwindow (size [1 1])".getBytes(StandardCharsets.UTF_8)))
                .isFalse();
        assertThat(format.recognizes(new byte[0])).isFalse();
    }

    @Test
    void aThingIsNotMovedByItsTilt() {
        Entity tilted = Worlds.of(
                        Worlds.model("m", "<pose>1 2 1 0 0.3 0.7</pose>", "<sphere><radius>1</radius></sphere>"))
                .thing("m");
        assertThat(only(tilted).shape()).isEqualTo(new Shape.Disc(new Point2d(0, 0), 1));
    }
}
