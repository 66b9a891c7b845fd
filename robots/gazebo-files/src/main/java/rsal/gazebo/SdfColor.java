package rsal.gazebo;

import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import rsal.data.Rgb;
import rsal.model.xml.XmlElement;

/// Colors of visuals.
final class SdfColor {
    /// What materials look like that come with Gazebo Classic.
    private static final Map<String, Rgb> MATERIALS = Map.ofEntries(
            Map.entry("gazebo/grey", new Rgb(0xb3, 0xb3, 0xb3)),
            Map.entry("gazebo/darkgrey", new Rgb(0x2d, 0x2d, 0x2d)),
            Map.entry("gazebo/white", new Rgb(0xff, 0xff, 0xff)),
            Map.entry("gazebo/black", new Rgb(0, 0, 0)),
            Map.entry("gazebo/flatblack", new Rgb(0x1a, 0x1a, 0x1a)),
            Map.entry("gazebo/red", new Rgb(0xff, 0, 0)),
            Map.entry("gazebo/green", new Rgb(0, 0xff, 0)),
            Map.entry("gazebo/blue", new Rgb(0, 0, 0xff)),
            Map.entry("gazebo/yellow", new Rgb(0xff, 0xff, 0)),
            Map.entry("gazebo/orange", new Rgb(0xff, 0x84, 0x12)),
            Map.entry("gazebo/purple", new Rgb(0xff, 0, 0xff)),
            Map.entry("gazebo/turquoise", new Rgb(0, 0xff, 0xff)),
            Map.entry("gazebo/wood", new Rgb(0x8b, 0x5a, 0x2b)));

    private SdfColor() {}

    /// Empty when a visual tells none.
    static Optional<Rgb> of(Optional<XmlElement> visual) {
        Optional<XmlElement> material = visual.flatMap(reported -> reported.first("material"));
        return material.flatMap(reported -> reported.first("diffuse"))
                .or(() -> material.flatMap(reported -> reported.first("ambient")))
                .flatMap(SdfColor::read)
                .or(() -> material.flatMap(reported -> reported.first("script", "name"))
                        .flatMap(name ->
                                Optional.ofNullable(MATERIALS.get(name.text().toLowerCase(Locale.ROOT)))));
    }

    private static Optional<Rgb> read(XmlElement color) {
        String[] parts = color.text().split("\\s+", 5);
        var rgb = new int[3];
        try {
            for (int i = 0; i < 3; i++) {
                rgb[i] = (int) Math.round(255 * Math.clamp(Double.parseDouble(parts[i]), 0.0, 1.0));
            }
        } catch (NumberFormatException | IndexOutOfBoundsException _) {
            return Optional.empty();
        }
        return Optional.of(new Rgb(rgb[0], rgb[1], rgb[2]));
    }

    /// As SDF writes it: red, green, blue and opacity from 0 to 1.
    static String written(Rgb color) {
        return "%s %s %s 1".formatted(part(color.red()), part(color.green()), part(color.blue()));
    }

    private static String part(int part) {
        return String.format(Locale.ROOT, "%.4f", part / 255.0);
    }
}
