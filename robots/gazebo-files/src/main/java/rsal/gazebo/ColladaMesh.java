package rsal.gazebo;

import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.StringTokenizer;
import org.jspecify.annotations.Nullable;
import rsal.model.xml.XmlElement;
import rsal.settings.InvalidSettings;

/// The corners of a mesh in COLLADA 1.4.1 or 1.5 (Khronos, 2008), in m with z upwards: positions of all geometries that
/// its scene shows, by the transforms of nodes. Skins are taken in the pose they were bound in; without a scene, all
/// geometries are taken as they are.
final class ColladaMesh {
    private static final int MOST_ELEMENTS = 500_000;
    private static final int MOST_INSTANCES = 10_000; // nodes may show others, which show others
    private static final int DEEPEST = 50;
    private static final double[] SAME = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}; // three rows of four

    private final XmlElement root;
    private final MeshExtent extent = new MeshExtent();
    private final Map<String, XmlElement> nodes = new HashMap<>(); // by id
    private final Map<String, XmlElement> geometries = new HashMap<>();
    private final Map<String, String> skins = new HashMap<>(); // geometries by controllers
    private int instances;

    private ColladaMesh(XmlElement root) {
        this.root = root;
        root.all("library_nodes").flatMap(library -> library.all("node")).forEach(this::learn);
        root.all("library_geometries")
                .flatMap(library -> library.all("geometry"))
                .forEach(geometry -> geometries.putIfAbsent(geometry.attribute("id"), geometry));
        root.all("library_controllers")
                .flatMap(library -> library.all("controller"))
                .forEach(controller -> controller
                        .first("skin")
                        .ifPresent(
                                skin -> skins.putIfAbsent(controller.attribute("id"), id(skin.attribute("source")))));
    }

    /// The box around a mesh.
    ///
    /// @return empty when it is no COLLADA, or has no corner that can be read
    static Optional<MeshBounds> bounds(byte[] file) {
        try {
            XmlElement root = XmlElement.read(new String(file, StandardCharsets.UTF_8), "mesh", MOST_ELEMENTS, "");
            return root.name().equals("COLLADA") ? new ColladaMesh(root).bounds() : Optional.empty();
        } catch (InvalidSettings | NumberFormatException _) {
            return Optional.empty();
        }
    }

    private void learn(XmlElement node) {
        nodes.putIfAbsent(node.attribute("id"), node);
        node.all("node").forEach(this::learn);
    }

    private Optional<MeshBounds> bounds() {
        double[] zUp = zUp();
        Optional<XmlElement> scene = root.first("scene", "instance_visual_scene")
                .map(instance -> id(instance.attribute("url")))
                .flatMap(id -> root.all("library_visual_scenes")
                        .flatMap(library -> library.all("visual_scene"))
                        .filter(each -> each.attribute("id").equals(id))
                        .findFirst());
        if (scene.isPresent()) {
            scene.get().all("node").forEach(this::learn);
            scene.get().all("node").forEach(node -> show(node, zUp, 0));
        } else {
            geometries.values().forEach(geometry -> add(geometry, zUp));
        }
        return extent.bounds();
    }

    /// From the file's axes and unit.
    private double[] zUp() {
        double meter = root.first("asset", "unit")
                .map(unit -> unit.numbers("meter", 1)[0])
                .orElse(1.0);
        String up = root.first("asset", "up_axis").map(XmlElement::text).orElse("Y_UP"); // as COLLADA says
        return switch (up) {
            case "Z_UP" -> new double[] {meter, 0, 0, 0, 0, meter, 0, 0, 0, 0, meter, 0};
            case "X_UP" -> new double[] {0, -meter, 0, 0, 0, 0, -meter, 0, meter, 0, 0, 0};
            default -> new double[] {meter, 0, 0, 0, 0, 0, -meter, 0, 0, meter, 0, 0};
        };
    }

    private void show(XmlElement node, double[] parent, int depth) {
        if (++instances > MOST_INSTANCES || depth > DEEPEST) {
            return;
        }
        double[] meshFromNode = parent;
        for (XmlElement child : node.children()) { // transforms come first, in their order
            meshFromNode = product(meshFromNode, transform(child));
        }
        for (XmlElement child : node.children()) {
            String id = id(child.attribute("url"));
            switch (child.name()) {
                case "node" -> show(child, meshFromNode, depth + 1);
                case "instance_node" -> {
                    if (nodes.containsKey(id)) {
                        show(nodes.get(id), meshFromNode, depth + 1);
                    }
                }
                case "instance_geometry" -> add(geometries.get(id), meshFromNode);
                case "instance_controller" -> add(geometries.get(skins.get(id)), meshFromNode);
                default -> {} // cameras, lights
            }
        }
    }

    private static double[] transform(XmlElement element) {
        return switch (element.name()) {
            case "matrix" -> element.numbers(16); // row by row; the last row is 0 0 0 1
            case "translate" -> {
                double[] by = element.numbers(3);
                yield new double[] {1, 0, 0, by[0], 0, 1, 0, by[1], 0, 0, 1, by[2]};
            }
            case "scale" -> {
                double[] by = element.numbers(3);
                yield new double[] {by[0], 0, 0, 0, 0, by[1], 0, 0, 0, 0, by[2], 0};
            }
            case "rotate" -> rotation(element.numbers(4));
            default -> SAME;
        };
    }

    /// Around an axis, by degrees (Rodrigues' formula).
    private static double[] rotation(double[] axisAndAngle) {
        double norm = Math.hypot(Math.hypot(axisAndAngle[0], axisAndAngle[1]), axisAndAngle[2]);
        if (norm == 0) {
            return SAME;
        }
        double x = axisAndAngle[0] / norm;
        double y = axisAndAngle[1] / norm;
        double z = axisAndAngle[2] / norm;
        double c = Math.cos(Math.toRadians(axisAndAngle[3]));
        double s = Math.sin(Math.toRadians(axisAndAngle[3]));
        double t = 1 - c;
        return new double[] {
            t * x * x + c,
            t * x * y - s * z,
            t * x * z + s * y,
            0,
            t * x * y + s * z,
            t * y * y + c,
            t * y * z - s * x,
            0,
            t * x * z - s * y,
            t * y * z + s * x,
            t * z * z + c,
            0
        };
    }

    /// First the second, then the first.
    private static double[] product(double[] a, double[] b) {
        var product = new double[12];
        for (int row = 0; row < 3; row++) {
            for (int column = 0; column < 4; column++) {
                double sum = column == 3 ? a[4 * row + 3] : 0;
                for (int k = 0; k < 3; k++) {
                    sum += a[4 * row + k] * b[4 * k + column];
                }
                product[4 * row + column] = sum;
            }
        }
        return product;
    }

    private void add(@Nullable XmlElement geometry, double[] by) {
        if (geometry == null) {
            return;
        }
        Optional<XmlElement> mesh = geometry.first("mesh");
        List<String> positions = mesh.flatMap(found -> found.first("vertices")).stream()
                .flatMap(vertices -> vertices.all("input"))
                .filter(input -> input.attribute("semantic").equals("POSITION"))
                .map(input -> id(input.attribute("source")))
                .toList();
        mesh.stream()
                .flatMap(found -> found.all("source"))
                .filter(source -> positions.contains(source.attribute("id")))
                .forEach(source -> addCorners(source, by));
    }

    private void addCorners(XmlElement source, double[] by) {
        Optional<XmlElement> accessor = source.first("technique_common", "accessor");
        int stride = accessor.map(found -> (int) found.numbers("stride", 3)[0]).orElse(3);
        int offset = accessor.map(found -> (int) found.numbers("offset", 0)[0]).orElse(0);
        var words = new StringTokenizer(
                source.first("float_array").map(XmlElement::text).orElse(""));
        for (int skipped = 0; skipped < offset && words.hasMoreTokens(); skipped++) {
            words.nextToken();
        }
        var corner = new double[3];
        for (int i = 0; stride >= 3 && words.hasMoreTokens(); i = (i + 1) % stride) {
            String word = words.nextToken();
            if (i < 3) {
                corner[i] = Double.parseDouble(word);
            }
            if (i == 2) {
                extent.add(
                        by[0] * corner[0] + by[1] * corner[1] + by[2] * corner[2] + by[3],
                        by[4] * corner[0] + by[5] * corner[1] + by[6] * corner[2] + by[7],
                        by[8] * corner[0] + by[9] * corner[1] + by[10] * corner[2] + by[11]);
            }
        }
    }

    private static String id(String url) {
        return url.startsWith("#") ? url.substring(1) : url;
    }
}
