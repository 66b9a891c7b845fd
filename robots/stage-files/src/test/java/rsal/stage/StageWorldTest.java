package rsal.stage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.data.Pose2d;
import rsal.stage.Traits.Energy;
import rsal.stage.Traits.Returns;

/// What world files mean: names, places, and what all models have.
class StageWorldTest {
    @Test
    void modelsAreNamedAfterTheirParentTypeAndNumber() {
        assertThat(Worlds.of("""
                        define cart position ( ranger ( ) ranger ( name "laser" ) ranger ( ) )
                        cart ( )
                        model ( )
                        cart ( name "r1" model ( name "/flag" model ( ) ) )
                        cart ( )
                        """).names())
                .containsExactly(
                        "position:0",
                        "position:0.ranger:0",
                        "position:0.laser",
                        "position:0.ranger:2",
                        "model:0",
                        "r1",
                        "r1.ranger:0",
                        "r1.laser",
                        "r1.ranger:2",
                        "flag",
                        "flag.model:0",
                        "position:2",
                        "position:2.ranger:0",
                        "position:2.laser",
                        "position:2.ranger:2");
    }

    @Test
    void namesStayUniqueWhenAWorldRepeatsThem() {
        assertThat(Worlds.of("model ( name \"a~2\" )" + "model ( name \"a\" model ( ) )".repeat(3))
                        .names())
                .containsExactly("a~2", "a", "a.model:0", "a~3", "a~3.model:0", "a~4", "a~4.model:0")
                .doesNotHaveDuplicates();
    }

    @Test
    void aModelHasStagesDefaults() {
        Traits traits = Worlds.of("model ( )").model().traits();
        assertThat(traits.kind()).isEqualTo(new ModelKind.Thing());
        assertThat(traits.size()).isEqualTo(new Size(0.4, 0.4, 1));
        assertThat(traits.origin()).isEqualTo(Placement.ORIGIN);
        assertThat(traits.color()).contains(StageColor.RED);
        assertThat(traits.returns()).isEqualTo(new Returns(true, 1, true, 0, 0, false));
        assertThat(traits.energy()).isEqualTo(new Energy(OptionalDouble.empty(), OptionalDouble.empty(), 0, 0, 0));
        assertThat(traits.mass()).isZero();
        assertThat(traits.stacksChildren()).isTrue();
        assertThat(traits.alwaysOn()).isFalse();
        assertThat(traits.updateInterval()).hasMillis(100);
        assertThat(traits.controllers()).isEmpty();
    }

    @Test
    void aModelHasWhatItSays() {
        Traits traits = Worlds.of("""
                model ( size [1 2 3] origin [0.1 0.2 0.3 90] color "navy blue" mass 7 alwayson 1 stack_children 0
                        update_interval 250 obstacle_return 0 ranger_return -1 blob_return 0 fiducial_return 12
                        fiducial_key 3 gripper_return 1 )
                """).model().traits();
        assertThat(traits.size()).isEqualTo(new Size(1, 2, 3));
        assertThat(traits.origin()).isEqualTo(Placement.of(0.1, 0.2, 0.3, Math.PI / 2));
        assertThat(traits.color()).contains(new StageColor(0, 0, 128, 255));
        assertThat(traits.returns()).isEqualTo(new Returns(false, -1, false, 12, 3, true));
        assertThat(traits.mass()).isEqualTo(7);
        assertThat(traits.stacksChildren()).isFalse();
        assertThat(traits.alwaysOn()).isTrue();
        assertThat(traits.updateInterval()).hasMillis(250);
    }

    @ParameterizedTest
    @CsvSource({
        "DarkOliveGreen, 556b2f",
        "dark olive green, 556b2f",
        "GREY30, 4d4d4d",
        "gray, bebebe",
        "LightGoldenrod4, 8b814c",
        "red, ff0000"
    })
    void colorsGoByTheirNamesInX11(String name, String rgb) {
        StageColor color = Worlds.of("model ( color \"%s\" )".formatted(name))
                .model()
                .traits()
                .color()
                .orElseThrow();
        assertThat(color.rgb()).isEqualTo(Integer.parseInt(rgb, 16));
        assertThat(color.alpha()).isEqualTo(255);
    }

    @Test
    void colorsMayBeMixedOrDrawn() {
        assertThat(Worlds.of("model ( color_rgba [0 0.5 1 0.2] )")
                        .model()
                        .traits()
                        .color())
                .contains(new StageColor(0, 128, 255, 51));
        assertThat(Worlds.of("model ( color \"blue\" color_rgba [1 0 0 1] )")
                        .model()
                        .traits()
                        .color())
                .contains(StageColor.BLUE);
        assertThat(Worlds.of("model ( color \"random\" )").model().traits().color())
                .isEmpty();
    }

    @Test
    void modelsStandOnTopOfTheirParent() {
        var named = Worlds.of("""
                model ( name "table" size [1 1 0.7] pose [2 3 0.1 90]
                  model ( name "box" size [0.2 0.2 0.3] pose [1 0 0.05 90] model ( name "cup" pose [1 0 0 0] ) )
                )
                """).named();
        near(named.get("table").worldFromModel(), Placement.of(2, 3, 0.1, Math.PI / 2));
        near(named.get("table.box").worldFromModel(), Placement.of(2, 4, 0.85, Math.PI));
        near(named.get("table.box.cup").worldFromModel(), Placement.of(1, 4, 1.15, Math.PI));
        near(named.get("table.box").parentFromModel(), Placement.of(1, 0, 0.05, Math.PI / 2));
    }

    @Test
    void modelsStandBesideAParentThatDoesNotStack() {
        var named = Worlds.of(
                        "model ( name \"a\" stack_children 0 pose [0 0 1 0] model ( name \"b\" pose [0 0 2 0] ) )")
                .named();
        near(named.get("a.b").worldFromModel(), Placement.of(0, 0, 3, 0));
    }

    @Test
    void anOriginMovesTheBodyButNotTheChildren() {
        var named = Worlds.of("model ( name \"a\" size [2 2 1] origin [1 0 0 0] model ( name \"b\" ) )")
                .named();
        near(named.get("a.b").worldFromModel(), Placement.of(0, 0, 1, 0));
        assertThat(named.get("a").traits().body().prisms().getFirst().outline())
                .allSatisfy(corner -> assertThat(corner.x()).isBetween(0.0, 2.0));
    }

    @ParameterizedTest
    @CsvSource({"m, degrees, 1, 180", "cm, radians, 0.01, 3.14159265358979", "mm, radians, 0.001, 3.14159265358979"})
    void lengthsAndAnglesAreInTheFilesUnits(String length, String angle, double meters, double half) {
        var world = Worlds.of("""
                position ( pose [100 200 300 %1$s] size [10 20 30] velocity_bounds [-5 5 0 0 0 0 -%1$s %1$s] mass 8
                           ranger ( sensor ( range [100 500] fov %1$s ) ) blobfinder ( range 9 ) )
                unit_length "%2$s"
                unit_angle "%3$s"
                resolution 0.05
                """.formatted(half, length, angle)).read();
        StageModel base = world.models().getFirst();
        near(base.worldFromModel(), Placement.of(100 * meters, 200 * meters, 300 * meters, Math.PI));
        assertThat(base.traits().size().x()).isCloseTo(10 * meters, within(1e-12));
        assertThat(base.traits().mass()).isEqualTo(8);
        assertThat(world.resolution()).isEqualTo(0.05);
        var position = (ModelKind.Position) base.traits().kind();
        assertThat(position.speeds().x().max()).isCloseTo(5 * meters, within(1e-12));
        assertThat(position.speeds().turn().max()).isCloseTo(Math.PI, within(1e-9));
        var ranger = (ModelKind.Ranger) base.children().getFirst().traits().kind();
        assertThat(ranger.transducers().getFirst().range().max()).isCloseTo(500 * meters, within(1e-9));
        assertThat(ranger.transducers().getFirst().fov()).isCloseTo(Math.PI, within(1e-9));
        var blobfinder =
                (ModelKind.Blobfinder) base.children().getLast().traits().kind();
        assertThat(blobfinder.range()).isEqualTo(9);
    }

    @Test
    void modelsOfOneMakeShareTheirTraits() {
        var named = Worlds.of("""
                define cart position ( ranger ( sensor ( ) ) )
                define bot cart ( )
                cart ( name "a" pose [1 0 0 0] )
                bot ( name "b" pose [2 0 0 0] )
                cart ( name "c" mass 3 )
                """).named();
        assertThat(named.get("a").traits()).isSameAs(named.get("b").traits());
        assertThat(named.get("c").traits()).isNotEqualTo(named.get("a").traits());
        assertThat(named.get("c").traits().mass()).isEqualTo(3);
        assertThat(named.get("c.ranger:0").traits())
                .isSameAs(named.get("a.ranger:0").traits());
        assertThat(named.get("a").macro()).isEqualTo("cart");
        assertThat(named.get("b").macro()).isEqualTo("bot");
        near(named.get("b").worldFromModel(), Placement.of(2, 0, 0, 0));
    }

    @Test
    void energyIsStoredUsedAndExchanged() {
        assertThat(energy("joules 500 watts 3 give_watts 4 take_watts 5"))
                .isEqualTo(new Energy(OptionalDouble.of(500), OptionalDouble.of(500), 3, 4, 5));
        assertThat(energy("kjoules 5 kjoules_capacity 9"))
                .isEqualTo(new Energy(OptionalDouble.of(5000), OptionalDouble.of(9000), 0, 0, 0));
        assertThat(energy("kjoules -1"))
                .isEqualTo(new Energy(
                        OptionalDouble.of(Double.POSITIVE_INFINITY),
                        OptionalDouble.of(Double.POSITIVE_INFINITY),
                        0,
                        0,
                        0));
        assertThat(energy("joules_capacity 70").stored()).hasValue(0);
    }

    @Test
    void sensorsUseEnergyThoughNobodySaysSo() {
        var named = Worlds.of("position ( name \"r\" ranger ( sensor ( ) sensor ( ) ) blobfinder ( ) fiducial ( ) )")
                .named();
        assertThat(named.get("r.ranger:0").traits().energy().use()).isEqualTo(0.4);
        assertThat(named.get("r.blobfinder:0").traits().energy().use()).isEqualTo(2);
        assertThat(named.get("r.fiducial:0").traits().energy().use()).isZero();
    }

    private static Energy energy(String properties) {
        return Worlds.of("model ( %s )".formatted(properties)).model().traits().energy();
    }

    private static void near(Placement actual, Placement expected) {
        assertThat(actual.pose().isNear(expected.pose(), 1e-9, 1e-9))
                .as("%s near %s", actual, expected)
                .isTrue();
        assertThat(actual.z()).isCloseTo(expected.z(), within(1e-9));
    }

    @Test
    void placementsComposeLikePoses() {
        var aFromB = new Placement(new Pose2d(1, 2, Math.PI / 2), 3);
        near(aFromB.compose(Placement.of(1, 0, 1, 0)), Placement.of(1, 3, 4, Math.PI / 2));
        assertThat(List.of(aFromB.compose(Placement.ORIGIN), Placement.ORIGIN.compose(aFromB)))
                .allSatisfy(same -> near(same, aFromB));
    }
}
