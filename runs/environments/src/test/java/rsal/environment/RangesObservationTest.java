package rsal.environment;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.data.Rep117;

class RangesObservationTest {
    @Test
    void eachSectorHasTheLeastOfItsOwnBeams() {
        for (long seed = 0; seed < 2000; seed++) {
            var random = new SplittableRandom(seed);
            int sectors = random.nextInt(1, 50);
            var ranges = new float[random.nextInt(3) == 0 ? sectors : random.nextInt(200)];
            for (int i = 0; i < ranges.length; i++) {
                ranges[i] = switch (random.nextInt(6)) {
                    case 0 -> Float.POSITIVE_INFINITY;
                    case 1 -> Float.NEGATIVE_INFINITY;
                    case 2 -> Float.NaN;
                    case 3 -> 0;
                    default -> (float) random.nextDouble(12);
                };
            }
            double least = random.nextBoolean() ? 0 : 0.3;
            var seen = new float[sectors + 2];
            RangesObservation.fill(ranges, least, sectors, 8, seen, 1);
            var wanted = new float[sectors + 2];
            for (int sector = 0; sector < sectors; sector++) {
                wanted[sector + 1] = 8;
                for (int beam = 0; beam < ranges.length; beam++) {
                    boolean own = ranges.length < sectors
                            ? 2 * sectors * beam <= (2 * sector + 1) * ranges.length // its middle is in this beam
                                    && (2 * sector + 1) * ranges.length < 2 * sectors * (beam + 1)
                            : (long) sector * ranges.length / sectors <= beam
                                    && beam < (long) (sector + 1) * ranges.length / sectors;
                    double distance = Rep117.distance(ranges[beam], least);
                    wanted[sector + 1] = own && distance < wanted[sector + 1] ? (float) distance : wanted[sector + 1];
                }
            }
            assertThat(seen).as("seed %d", seed).containsExactly(wanted);
        }
    }
}
