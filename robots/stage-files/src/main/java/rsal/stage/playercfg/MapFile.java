package rsal.stage.playercfg;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.map.Maps;
import rsal.settings.InvalidSettings;
import rsal.settings.Value;
import rsal.stage.WorldFiles;
import rsal.stage.WorldProblems;

/// Reads the map that a configuration's drivers `mapfile` have. A run has one, so that the first counts; one that can't
/// be read leaves robots with what is made of their world.
final class MapFile {
    private static final String NAME = "mapfile";

    private final PlayerConfig config;
    private final WorldFiles files;
    private final WorldProblems findings;

    MapFile(PlayerConfig config, WorldFiles files, WorldProblems findings) {
        this.config = config;
        this.files = files;
        this.findings = findings;
    }

    Optional<OccupancyGrid> read() {
        List<Driver> all = config.drivers().stream()
                .filter(driver -> driver.name().equals(NAME))
                .toList();
        if (all.isEmpty()) {
            return Optional.empty();
        }
        Driver first = all.getFirst();
        all.stream()
                .skip(1)
                .filter(other -> !said(other).equals(said(first)))
                .forEach(other -> findings.warn(
                        other.location(),
                        "This 'mapfile' serves the map of the first one, at %s.".formatted(first.location()),
                        "Robots of a run know one map."));
        try {
            return Optional.of(read(first));
        } catch (InvalidSettings e) {
            var why = e.problems().getFirst();
            findings.warn(
                    first.location(),
                    "The map is made of the world, as that of 'mapfile' can't be read: " + why.message(),
                    why.remedy());
            return Optional.empty();
        }
    }

    /// What is said of a map, wherever.
    private static List<String> said(Driver driver) {
        return List.of("filename", "resolution", "negate", "origin").stream()
                .map(name -> driver.option(name)
                        .map(Driver.Option::value)
                        .map(MapFile::plain)
                        .orElse("nothing"))
                .toList();
    }

    private static String plain(Value value) {
        return value instanceof Value.Sequence list
                ? list.items().stream().map(MapFile::plain).toList().toString()
                : value.describe();
    }

    private OccupancyGrid read(Driver driver) {
        Driver.Option named = driver.option("filename")
                .filter(option -> ConfigReader.text(option.value()).isPresent())
                .orElseThrow(() ->
                        new InvalidSettings(driver.location(), "It names no file.", "Write filename \"MAP.png\"."));
        double resolution = number(driver, "resolution").orElse(0) * config.meters();
        if (!(resolution >= 0.001 && resolution <= 100)) {
            throw new InvalidSettings(
                    driver.location(),
                    "Its 'resolution' is not from 0.001 to 100 [m].",
                    "Write resolution 0.05, with the side of a pixel.");
        }
        String name = ConfigReader.text(named.value()).orElseThrow();
        WorldFiles.Found image = files.find(
                name, config.path(), Maps.MAX_IMAGE_BYTES, named.value().location());
        boolean negate = number(driver, "negate").orElse(0) != 0;
        return Maps.ofMapfile(image.path(), image.bytes(), resolution, negate, corner(driver));
    }

    private static OptionalDouble number(Driver driver, String name) {
        return driver.option(name)
                .map(Driver.Option::value)
                .flatMap(MapFile::number)
                .map(OptionalDouble::of)
                .orElse(OptionalDouble.empty());
    }

    private static Optional<Double> number(Value value) {
        return value instanceof Value.Scalar scalar && scalar.value() instanceof Number number
                ? Optional.of(number.doubleValue())
                : Optional.empty();
    }

    private Optional<Point2d> corner(Driver driver) {
        Driver.Option origin = driver.option("origin").orElse(null);
        if (origin == null) {
            return Optional.empty();
        }
        var numbers = new ArrayList<Double>();
        if (origin.value() instanceof Value.Sequence list) {
            list.items().forEach(item -> number(item).ifPresent(numbers::add));
        }
        if (numbers.size() < 2 || numbers.stream().anyMatch(number -> !(Math.abs(number) <= 1e6))) {
            throw new InvalidSettings(
                    origin.location(),
                    "Its 'origin' is not a position.",
                    "Write origin [X Y], with the lower left corner.");
        }
        return Optional.of(new Point2d(numbers.get(0) * config.meters(), numbers.get(1) * config.meters()));
    }
}
