package rsal.world.yaml;

import java.util.Optional;
import java.util.function.UnaryOperator;
import rsal.model.BodyReader;
import rsal.scene.Surface;
import rsal.settings.Parameter;
import rsal.settings.Section;

/// Reads what sensors and others make of something.
final class SurfaceReader {
    private SurfaceReader() {}

    /// With the color that is told.
    ///
    /// @param base what counts where nothing is said
    static Surface read(Section section, Surface base) {
        Surface surface = reported(section).apply(base);
        return section.has("color") ? surface.in(BodyReader.color(section, "color")) : surface;
    }

    /// What is said, but the color, put over what is there otherwise.
    static UnaryOperator<Surface> reported(Section section) {
        Optional<Object> obstacle = find(section, Keys.OBSTACLE);
        Optional<Object> reflectance = find(section, Keys.REFLECTANCE);
        Optional<Object> blob = find(section, Keys.BLOB);
        Optional<Object> fiducial = find(section, Keys.FIDUCIAL);
        Optional<Object> key = find(section, Keys.KEY);
        Optional<Object> grippable = find(section, Keys.GRIPPABLE);
        return base -> new Surface(
                base.color(),
                obstacle.map(Boolean.class::cast).orElse(base.obstacle()),
                reflectance.map(Double.class::cast).orElse(base.reflectance()),
                blob.map(Boolean.class::cast).orElse(base.blob()),
                fiducial.map(id -> ((Long) id).intValue()).orElse(base.fiducial()),
                key.map(id -> ((Long) id).intValue()).orElse(base.fiducialKey()),
                grippable.map(Boolean.class::cast).orElse(base.grippable()));
    }

    private static Optional<Object> find(Section section, Parameter<?> parameter) {
        return section.has(parameter.name()) ? section.value(parameter) : Optional.empty();
    }
}
