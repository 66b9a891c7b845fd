package rsal.navigation.carmen;

import java.util.OptionalDouble;

/// Whether the headings of odometry are degrees: they go beyond two turns, so that they are no angles in [-π, π), and
/// from one message to the next by more than a radian again and again, as what was never wrapped does not. Steps from
/// one angle in [-2π, 2π] to another don't count: wrapped radians jump there.
final class Headings {
    private static final double ONE_TURN = 2 * Math.PI; // rad
    private static final double TWO_TURNS = 4 * Math.PI; // rad
    private static final double LARGE = 1; // rad
    private static final int MANY = 5; // large steps
    private static final double MANY_OF_ALL = 0.02; // the same

    private double last = Double.NaN;
    private double most;
    private int steps;
    private int largeSteps;

    /// @param heading as it stands in the log
    void add(double heading) {
        most = Math.max(most, Math.abs(heading));
        if (heading != last) {
            steps++;
            boolean beyond = Math.max(Math.abs(last), Math.abs(heading)) > ONE_TURN;
            largeSteps += beyond && Math.abs(heading - last) > LARGE ? 1 : 0; // none before the first
        }
        last = heading;
    }

    /// The largest of them, when they are degrees.
    OptionalDouble degrees() {
        return most > TWO_TURNS && largeSteps >= Math.max(MANY, MANY_OF_ALL * steps)
                ? OptionalDouble.of(most)
                : OptionalDouble.empty();
    }
}
