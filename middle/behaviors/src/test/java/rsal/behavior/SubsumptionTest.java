package rsal.behavior;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;
import rsal.data.Twist2d;

class SubsumptionTest {
    private static final Behavior GO = new SetSpeed(Twist2d.drive(0.4, 0));
    private static final Behavior AGREE = (_, below) -> below;

    private final Percept percept = Scene.open().percept();

    @Test
    void withoutLayersItStandsStill() {
        Decision decision = new Subsumption().decide(percept);
        assertThat(decision.twist()).isEqualTo(Twist2d.STOP);
        assertThat(decision.inCharge()).isEmpty();
    }

    @Test
    void theUppermostThatChangesSomethingIsInCharge() {
        var stack = new Subsumption()
                .layer("go", GO)
                .layer("halve", (_, below) -> Twist2d.drive(below.vx() / 2, below.omega()))
                .layer("agree", AGREE);
        Decision decision = stack.decide(percept);
        assertThat(decision.twist()).isEqualTo(Twist2d.drive(0.2, 0));
        assertThat(decision.inCharge()).isEqualTo("halve");
    }

    @Test
    void theLowestIsInChargeWhenTheOthersAgree() {
        assertThat(new Subsumption()
                        .layer("stand", AGREE)
                        .layer("agree", AGREE)
                        .decide(percept)
                        .inCharge())
                .isEqualTo("stand");
    }

    @Test
    void layersComeAndGoAtRunTime() {
        var stack = new Subsumption().layer("go", GO).layer("top", AGREE);
        stack.layerAbove("go", "stop", new SetSpeed(Twist2d.STOP));
        assertThat(stack.names()).containsExactly("go", "stop", "top");
        assertThat(stack.decide(percept).twist()).isEqualTo(Twist2d.STOP);
        assertThat(stack.remove("stop")).isTrue();
        assertThat(stack.remove("stop")).isFalse();
        assertThat(stack.decide(percept).inCharge()).isEqualTo("go");
    }

    @Test
    void aBehaviorMayChangeTheStackItIsIn() {
        var stack = new Subsumption();
        stack.layer("once", (_, _) -> {
            stack.remove("once");
            return Twist2d.drive(1, 0);
        });
        assertThat(stack.decide(percept).twist()).isEqualTo(Twist2d.drive(1, 0));
        assertThat(stack.decide(percept).twist()).isEqualTo(Twist2d.STOP);
    }

    @Test
    void namesAreUniqueAndOthersMustBeThere() {
        var stack = new Subsumption().layer("go", GO);
        assertThatIllegalArgumentException().isThrownBy(() -> stack.layer("go", GO));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> stack.layerAbove("gone", "new", GO))
                .withMessageContaining("'gone'");
    }
}
