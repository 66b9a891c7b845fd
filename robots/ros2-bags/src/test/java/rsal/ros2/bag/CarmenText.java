package rsal.ros2.bag;

import java.util.Locale;

/// Logs of CARMEN for tests: a robot that drives ahead and turns.
final class CarmenText {
    private CarmenText() {}

    /// @param scans how many
    /// @param corrected whether somebody has corrected the poses, so that scans are not where the odometry is
    static String of(int scans, boolean corrected) {
        var text = new StringBuilder();
        for (int i = 0; i < scans; i++) {
            double time = 1_000_000 + i * 0.25;
            String odometry = "%.2f 0 %.2f".formatted(0.1 * i, 0.01 * i);
            text.append(String.format(Locale.ROOT, "ODOM %s 0.4 0.04 0 %.2f robot %.2f%n", odometry, time, i * 0.25));
            text.append("ROBOTLASER1 0 -1 2 0.5 30 0 0 5 1.5 2.25 30 0 4.5 0 ")
                    .append(corrected ? "%.2f 3 %.2f".formatted(0.1 * i, 0.01 * i) : odometry)
                    .append(' ')
                    .append(odometry)
                    .append(String.format(Locale.ROOT, " 0 0 0 0 0 %.2f robot %.2f%n", time, i * 0.25));
        }
        return text.toString();
    }
}
