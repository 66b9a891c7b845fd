package rsal.data;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.math.BigDecimal;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class AnglesTest {
    @Test
    void wrapsToTheSameDirectionFromMinusPiToPi() {
        var random = new Random(1);
        for (int i = 0; i < 10_000; i++) {
            double angle = (random.nextDouble() - 0.5) * Math.pow(10, random.nextInt(8));
            double wrapped = Angles.wrap(angle);
            assertThat(wrapped).as("%s", angle).isGreaterThanOrEqualTo(-Math.PI).isLessThan(Math.PI);
            assertThat(Math.cos(wrapped - angle)).as("%s", angle).isCloseTo(1, within(1e-9));
        }
    }

    @Test
    void wrapsAsIfByTheRemainderToTheLastBit() {
        var random = new Random(1);
        for (int i = 0; i < 100_000; i++) {
            double angle = (2 * random.nextDouble() - 1) * 3 * Math.PI;
            assertThat(Angles.wrap(angle)).as("%s", angle).isEqualTo(Math.IEEEremainder(angle, 2 * Math.PI));
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {-Math.PI, 0, 1, -1, 3.14})
    void leavesWrappedAnglesAsTheyAre(double angle) {
        assertThat(Angles.wrap(angle)).isEqualTo(angle);
    }

    @Test
    void piIsMinusPi() {
        assertThat(Angles.wrap(Math.PI)).isEqualTo(-Math.PI);
        for (int turns = -1000; turns <= 1000; turns++) {
            double around = Angles.wrap(Math.PI + turns * 2 * Math.PI);
            assertThat(around)
                    .as("%d turns", turns)
                    .isGreaterThanOrEqualTo(-Math.PI)
                    .isLessThan(Math.PI);
        }
        assertThat(Angles.wrap(Math.nextDown(-Math.PI))).isLessThan(Math.PI);
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
    void whatIsNoAngleIsNotANumber(double angle) {
        assertThat(Angles.wrap(angle)).isNaN();
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e9, -1e16, 9.42e36, -1e300})
    void anglesFarAwayKeepTheirDirection(double angle) {
        var turns = new BigDecimal(angle).remainder(new BigDecimal(2 * Math.PI));
        assertThat(Angles.wrap(angle)).isEqualTo(Angles.wrap(turns.doubleValue()));
    }

    @Test
    void theDifferenceOfAnglesTooFarApartToBeSubtractedIsThatOfTheirDirections() {
        double from = Double.MAX_VALUE;
        double to = -1e300;
        assertThat(from - to).isInfinite();
        assertThat(Angles.difference(from, to))
                .isCloseTo(Angles.difference(Angles.wrap(from), Angles.wrap(to)), within(1e-12));
        assertThat(Angles.difference(Double.POSITIVE_INFINITY, 0)).isNaN();
    }

    @Test
    void theDifferenceIsTheShorterTurn() {
        assertThat(Angles.difference(Math.toRadians(170), Math.toRadians(-170)))
                .isCloseTo(Math.toRadians(20), within(1e-12));
        assertThat(Angles.difference(Math.toRadians(-170), Math.toRadians(170)))
                .isCloseTo(Math.toRadians(-20), within(1e-12));
    }
}
