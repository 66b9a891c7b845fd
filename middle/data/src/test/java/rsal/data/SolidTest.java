package rsal.data;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.data.Shape.Disc;
import rsal.data.Shape.Polygon;

class SolidTest {
    private static final Polygon BOX = Polygon.of(Footprint.box(0.4, 0.2, new Point2d(0, 0)));

    @Test
    void aBoxKeepsItsOutline() {
        assertThat(Solid.standing(BOX, 0.3).hull()).isEqualTo(Footprint.box(0.4, 0.2, new Point2d(0, 0)));
    }

    @Test
    void theOutlineGoesAroundAllPieces() {
        var mast = new Prism(new Disc(new Point2d(0.5, 0), 0.1), 0.3, 1.2, Optional.of(new Rgb(255, 0, 0)));
        Solid body = new Solid(List.of(Prism.standing(BOX, 0.3), mast));
        assertThat(body.hull().circumscribedRadius()).isCloseTo(0.6, within(0.01));
        assertThat(body.hull().inscribedRadius()).isCloseTo(0.1, within(0.01));
        assertThat(body.top()).isEqualTo(1.2);
    }

    @Test
    void refusesPiecesWithoutHeightAndBodiesWithoutPieces() {
        assertThatIllegalArgumentException().isThrownBy(() -> Solid.standing(BOX, 0));
        assertThatIllegalArgumentException().isThrownBy(() -> Solid.standing(BOX, Double.NaN));
        assertThatIllegalArgumentException().isThrownBy(() -> new Solid(List.of()));
    }
}
