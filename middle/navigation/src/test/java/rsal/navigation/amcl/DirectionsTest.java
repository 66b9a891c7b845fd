package rsal.navigation.amcl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;

class DirectionsTest {
    @Test
    void areCosinesAndSinesToTheLastBitsOf1() {
        var random = new SplittableRandom(1);
        double[] angles = DoubleStream.concat(
                        DoubleStream.of(0, -0.0, Math.PI, -Math.PI, Math.PI / 2, -Math.PI / 2, 1e-300),
                        random.doubles(100_000, -Math.PI, Math.PI))
                .toArray();
        var directions = new Directions(angles.length);

        directions.of(angles, 0, angles.length);

        for (int i = 0; i < angles.length; i++) {
            assertThat(directions.cos[i]).as("cos %s", angles[i]).isCloseTo(StrictMath.cos(angles[i]), within(1e-15));
            assertThat(directions.sin[i]).as("sin %s", angles[i]).isCloseTo(StrictMath.sin(angles[i]), within(1e-15));
        }
    }

    @Test
    void ofSomeOfTheAngles() {
        var directions = new Directions(2);

        directions.of(new double[] {3, 1, 2, 3}, 1, 2);

        assertThat(directions.cos).containsExactly(new double[] {Math.cos(1), Math.cos(2)}, within(1e-15));
        assertThat(directions.sin).containsExactly(new double[] {Math.sin(1), Math.sin(2)}, within(1e-15));
    }
}
