package rsal.behavior;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

class SurroundingsTest {
    @Test
    void everyDirectionLiesInTheSectorAroundIt() {
        for (int sector = 0; sector < Surroundings.SECTORS; sector++) {
            assertThat(Surroundings.sector(Surroundings.direction(sector))).isEqualTo(sector);
            assertThat(Surroundings.sector(Surroundings.direction(sector) + 4 * Math.PI))
                    .isEqualTo(sector);
        }
        assertThat(Surroundings.sector(Math.PI)).isZero();
        assertThat(Surroundings.sector(Math.PI - 0.001)).isEqualTo(Surroundings.SECTORS - 1);
    }

    @Test
    void aPlaceLiesInTheSectorOfItsDirection() {
        var random = new Random(5);
        for (int round = 0; round < 1_000_000; round++) {
            isInTheSectorOfItsDirection(random.nextGaussian() * 3, random.nextGaussian() * 3);
        }
    }

    @Test
    void aPlaceOnOrBesideABorderLiesInTheSectorOfItsDirection() {
        var random = new Random(6);
        for (int round = 0; round < 300_000; round++) {
            double border = -Math.PI + random.nextInt(Surroundings.SECTORS + 1) * Surroundings.WIDTH;
            double direction = border + random.nextGaussian() * Math.pow(10, -2 - random.nextInt(15));
            double range = 10 * random.nextDouble();
            isInTheSectorOfItsDirection(range * Math.cos(direction), range * Math.sin(direction));
        }
        double[] special = {
            0, -0.0, 1, -1, 1e-310, 1e300, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NaN
        };
        for (double x : special) {
            for (double y : special) {
                isInTheSectorOfItsDirection(x, y);
            }
        }
    }

    private static void isInTheSectorOfItsDirection(double x, double y) {
        int sector = Surroundings.sector(Math.atan2(y, x));
        int guessed = Surroundings.sectorOf(x, y, sector);
        int guessedWrongly = Surroundings.sectorOf(x, y, (sector + 1) % Surroundings.SECTORS);
        if (Surroundings.sectorOf(x, y) != sector || guessed != sector || guessedWrongly != sector) {
            assertThat(List.of(Surroundings.sectorOf(x, y), guessed, guessedWrongly)) // words cost more than places
                    .as("x %s, y %s", x, y)
                    .containsOnly(sector);
        }
    }

    @Test
    void nearestLooksCounterClockwiseAlsoAcrossTheBack() {
        Surroundings around =
                Scene.open().thing(170, 2).thing(-170, 1).percept().surroundings();
        assertThat(around.nearest(Math.toRadians(160), Math.toRadians(-160))).isEqualTo(1);
        assertThat(around.nearest(Math.toRadians(160), Math.toRadians(175))).isEqualTo(2);
        assertThat(around.nearest(Math.toRadians(-160), Math.toRadians(160))).isInfinite();
    }

    @Test
    void aDiscMayBeAsWideAsTheThingsAsideOfItsWay() {
        Surroundings around =
                Scene.open().wall(90, 0.5).wall(-90, 0.4).percept().surroundings();
        assertThat(around.clearance(0, 1)).isCloseTo(0.4, within(0.01));
        assertThat(around.clearance(Math.toRadians(90), 1)).isCloseTo(0, within(0.02));
    }

    @Test
    void whatIsLeftBehindDoesNotCount() {
        Surroundings around = Scene.open().wall(180, 0.1).percept().surroundings();
        assertThat(around.clearance(0, 1)).isInfinite();
    }

    @Test
    void whatLiesBeyondThePlaceCountsByItsDistanceFromIt() {
        Surroundings around = Scene.open().thing(1, 1.5).percept().surroundings();
        assertThat(around.clearance(0, 1)).isCloseTo(0.5, within(0.01));
    }

    @Test
    void agreesWithRollingADiscAlongTheWay() {
        var random = new Random(11);
        for (int round = 0; round < 200; round++) {
            Scene scene = Scene.open();
            for (int i = 0; i < 20; i++) {
                scene.thing(360 * random.nextDouble(), 0.2 + 3 * random.nextDouble());
            }
            double heading = 6 * random.nextDouble();
            double length = random.nextDouble();
            Surroundings around = scene.percept().surroundings();
            double slow = Double.POSITIVE_INFINITY;
            for (int i = 0; i < around.things(); i++) {
                if (around.x(i) * Math.cos(heading) + around.y(i) * Math.sin(heading) <= 0) {
                    continue;
                }
                for (int step = 0; step <= 1000; step++) {
                    double x = length * step / 1000 * Math.cos(heading);
                    double y = length * step / 1000 * Math.sin(heading);
                    slow = Math.min(slow, Math.hypot(around.x(i) - x, around.y(i) - y));
                }
            }
            if (slow == Double.POSITIVE_INFINITY) {
                assertThat(around.clearance(heading, length)).isInfinite();
            } else {
                assertThat(around.clearance(heading, length))
                        .as("round %d", round)
                        .isCloseTo(slow, within(1e-3));
            }
        }
    }

    @Test
    void needsOneRangePerSector() {
        assertThatIllegalArgumentException().isThrownBy(() -> new Surroundings(new float[3]));
    }
}
