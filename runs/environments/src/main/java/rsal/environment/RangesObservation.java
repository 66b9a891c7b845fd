package rsal.environment;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import rsal.data.LaserScan;
import rsal.data.RangeArray;
import rsal.data.Rep117;
import rsal.data.Stamped;
import rsal.device.Device;
import rsal.device.LaserScanner;
import rsal.device.RangeSensor;
import rsal.device.SonarArray;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Ranges of a laser or of sonars, in sectors: of each sector the least one. Those of a laser are from right to left,
/// those of sonars in the order of the device, which is from left to right for a Pioneer's. Nothing in reach, and no
/// reading, are the greatest range. With fewer beams than sectors, each sector has the beam that is next to its middle.
public final class RangesObservation implements ObservationType {
    private static final Parameter<String> DEVICE =
            Parameter.text("device", "", "Name of the laser or the sonars. Default: the first one of the robot.");
    private static final Parameter<Integer> SECTORS = Parameter.integer(
            "sectors",
            36,
            1,
            10_000,
            "",
            "Number of sectors. With fewer beams, each sector has the beam that is next to its middle.");
    private static final Parameter<Double> MAX =
            Parameter.number("max", 8, 0.01, 1000, "m", "Greatest range; longer ones count as this one.");

    @Override
    public String key() {
        return "ranges";
    }

    @Override
    public String description() {
        return "Ranges of a laser or of sonars, the least one of each sector.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(DEVICE, SECTORS, MAX);
    }

    @Override
    public LearnerObservation create(Arguments arguments) {
        return new Ranges(
                arguments.get(DEVICE),
                arguments.get(SECTORS),
                arguments.get(MAX).floatValue());
    }

    private record Ranges(String device, int sectors, float max) implements LearnerObservation {
        private static final float[] NONE = new float[0]; // before the first reading

        @Override
        public List<String> fields() {
            return IntStream.range(0, sectors)
                    .mapToObj(sector -> "range %d [m]".formatted(sector))
                    .toList();
        }

        @Override
        public float[] low() {
            return Bounds.repeated(sectors, 0);
        }

        @Override
        public float[] high() {
            return Bounds.repeated(sectors, max);
        }

        @Override
        public Reader of(Robot robot, Truth world) {
            Device sensor = robot.devices().stream()
                    .filter(RangeSensor.class::isInstance)
                    .filter(each -> device.isEmpty() || each.info().name().equals(device))
                    .findFirst()
                    .orElseThrow(() -> new IllegalArgumentException("Robot '%s' has no %s for the observation 'ranges'."
                            .formatted(
                                    robot.id(),
                                    device.isEmpty() ? "laser or sonars" : "device '%s'".formatted(device))));
            return switch (sensor) {
                case LaserScanner laser ->
                    (to, at) -> {
                        Optional<Stamped<LaserScan>> newest = laser.latest();
                        if (newest.isPresent()) {
                            LaserScan scan = newest.get().value();
                            fill(scan.ranges(), scan.rangeMin(), sectors, max, to, at);
                        } else {
                            fill(NONE, 0, sectors, max, to, at);
                        }
                    };
                case SonarArray sonars ->
                    (to, at) -> {
                        Optional<Stamped<RangeArray>> newest = sonars.latest();
                        if (newest.isPresent()) {
                            RangeArray array = newest.get().value();
                            fill(array.ranges(), array.rangeMin(), sectors, max, to, at);
                        } else {
                            fill(NONE, 0, sectors, max, to, at);
                        }
                    };
                default ->
                    throw new IllegalArgumentException("Device '%s' is neither a laser nor sonars."
                            .formatted(sensor.info().id()));
            };
        }
    }

    /// Writes the least distance of each sector, of sectors with as many beams as each other, or one more. With fewer
    /// beams than sectors, each sector has the beam that is next to its middle.
    ///
    /// @param least range that the sensor measures [m]
    /// @param max distance of what is farther, and where nothing is [m]
    static void fill(float[] ranges, double least, int sectors, float max, float[] to, int at) {
        boolean isBeam = sectors == ranges.length; // each, so that nothing is divided
        boolean areFew = ranges.length > 0 && ranges.length < sectors;
        int beam = 0;
        for (int sector = 0; sector < sectors; sector++) {
            int end = isBeam ? sector + 1 : (int) ((long) (sector + 1) * ranges.length / sectors);
            if (areFew) {
                beam = (int) ((2L * sector + 1) * ranges.length / (2L * sectors));
                end = beam + 1;
            }
            float nearest = max;
            for (; beam < end; beam++) {
                double distance = Rep117.distance(ranges[beam], least);
                if (distance < nearest) { // false for no reading
                    nearest = (float) distance;
                }
            }
            to[at + sector] = nearest;
        }
    }
}
