package rsal.gazebo;

import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import rsal.model.xml.XmlElement;
import rsal.settings.InvalidSettings;

/// The corners of a mesh in COLLADA 1.4.1 or 1.5 (Khronos, 2008), in m: positions of all geometries that its scene
/// shows,
/// by the transforms of nodes. Skins are taken in the pose they were bound in; without a scene, all geometries are
/// taken
/// as they are. Axes are those of the file, whatever its `up_axis` says: Gazebo's loader does not turn meshes either.
final class ColladaMesh {
    private static final int MOST_ELEMENTS = 500_000;
    private static final int MOST_INSTANCES = 10_000; // nodes may show others, which show others
    private static final long MOST_CORNERS = 50_000_000; // of all instances
    private static final int DEEPEST = 50;
    private static final Pattern SPACES = Pattern.compile("\\s+");
    private static final double[] SAME = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}; // three rows of four

    private final XmlElement root;
    private final MeshExtent extent = new MeshExtent();
    private final Map<String, XmlElement> nodes = new HashMap<>(); // by id
    private final Map<String, XmlElement> geometries = new HashMap<>();
    private final Map<String, XmlElement> skins = new HashMap<>(); // by controllers
    private final IdentityHashMap<XmlElement, double[]> corners =
            new IdentityHashMap<>(); // of geometries: x, y, z and so on
    private int instances;
    private long shown; // corners

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
                        .ifPresent(skin -> skins.putIfAbsent(controller.attribute("id"), skin)));
    }

    /// The box around a mesh.
    ///
    /// @return empty when it is no COLLADA, has no corner that can be read, or shows more than can be
    static Optional<MeshBounds> bounds(byte[] file) {
        try {
            XmlElement root = XmlElement.read(text(file), "mesh", MOST_ELEMENTS, "");
            return root.name().equals("COLLADA") ? new ColladaMesh(root).bounds() : Optional.empty();
        } catch (InvalidSettings | NumberFormatException _) {
            return Optional.empty();
        }
    }

    /// UTF-8, or UTF-16 where a mark says so.
    private static String text(byte[] file) {
        int mark = file.length < 2 ? 0 : ((file[0] & 0xFF) << 8) | (file[1] & 0xFF);
        boolean isWide = mark == 0xFEFF || mark == 0xFFFE;
        String text = new String(file, isWide ? StandardCharsets.UTF_16 : StandardCharsets.UTF_8);
        return text.startsWith("\uFEFF") ? text.substring(1) : text;
    }

    private void learn(XmlElement node) {
        nodes.putIfAbsent(node.attribute("id"), node);
        node.all("node").forEach(this::learn);
    }

    private Optional<MeshBounds> bounds() {
        double meter = root.first("asset", "unit")
                .map(unit -> unit.numbers("meter", 1)[0])
                .orElse(1.0);
        double[] inMeters = {meter, 0, 0, 0, 0, meter, 0, 0, 0, 0, meter, 0};
        Optional<XmlElement> scene = root.first("scene", "instance_visual_scene")
                .map(instance -> id(instance.attribute("url")))
                .flatMap(id -> root.all("library_visual_scenes")
                        .flatMap(library -> library.all("visual_scene"))
                        .filter(each -> each.attribute("id").equals(id))
                        .findFirst());
        if (scene.isPresent()) {
            scene.get().all("node").forEach(this::learn);
            scene.get().all("node").forEach(node -> show(node, inMeters, 0));
        } else {
            geometries.values().forEach(geometry -> add(geometry, inMeters));
        }
        boolean isWhole = instances <= MOST_INSTANCES && shown <= MOST_CORNERS;
        return isWhole ? extent.bounds() : Optional.empty();
    }

    private void show(XmlElement node, double[] parent, int depth) {
        if (depth > DEEPEST) {
            instances = MOST_INSTANCES; // it shows itself
        }
        if (++instances > MOST_INSTANCES) {
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
                case "instance_controller" -> addSkin(skins.get(id), meshFromNode);
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

    private void addSkin(@Nullable XmlElement skin, double[] meshFromNode) {
        if (skin != null) {
            double[] nodeFromSkin = skin.first("bind_shape_matrix")
                    .map(matrix -> matrix.numbers(16))
                    .orElse(SAME);
            add(geometries.get(id(skin.attribute("source"))), product(meshFromNode, nodeFromSkin));
        }
    }

    private void add(@Nullable XmlElement geometry, double[] by) {
        if (geometry == null || shown > MOST_CORNERS) {
            return;
        }
        double[] its = corners.computeIfAbsent(geometry, ColladaMesh::corners);
        shown += 1 + its.length / 3;
        for (int i = 0; i < its.length && shown <= MOST_CORNERS; i += 3) {
            extent.add(
                    by[0] * its[i] + by[1] * its[i + 1] + by[2] * its[i + 2] + by[3],
                    by[4] * its[i] + by[5] * its[i + 1] + by[6] * its[i + 2] + by[7],
                    by[8] * its[i] + by[9] * its[i + 1] + by[10] * its[i + 2] + by[11]);
        }
    }

    /// x, y, z of all positions.
    private static double[] corners(XmlElement geometry) {
        Optional<XmlElement> mesh = geometry.first("mesh");
        List<String> positions = mesh.flatMap(found -> found.first("vertices")).stream()
                .flatMap(vertices -> vertices.all("input"))
                .filter(input -> input.attribute("semantic").equals("POSITION"))
                .map(input -> id(input.attribute("source")))
                .toList();
        return mesh.stream()
                .flatMap(found -> found.all("source"))
                .filter(source -> positions.contains(source.attribute("id")))
                .flatMapToDouble(ColladaMesh::positions)
                .toArray();
    }

    private static DoubleStream positions(XmlElement source) {
        Optional<XmlElement> accessor = source.first("technique_common", "accessor");
        int stride = accessor.map(found -> (int) found.numbers("stride", 3)[0]).orElse(3);
        int offset = accessor.map(found -> (int) found.numbers("offset", 0)[0]).orElse(0);
        double[] numbers = SPACES.splitAsStream(
                        source.first("float_array").map(XmlElement::text).orElse(""))
                .filter(word -> !word.isEmpty())
                .mapToDouble(ColladaMesh::number)
                .toArray();
        if (stride < 3 || offset < 0 || numbers.length - offset < 3) {
            return DoubleStream.empty();
        }
        int count = (numbers.length - offset - 3) / stride + 1;
        return IntStream.range(0, count)
                .flatMap(corner -> IntStream.range(offset + corner * stride, offset + corner * stride + 3))
                .mapToDouble(i -> numbers[i]);
    }

    private static double number(String word) {
        return switch (word) { // XML's words
            case "INF" -> Double.POSITIVE_INFINITY;
            case "-INF" -> Double.NEGATIVE_INFINITY;
            default -> Double.parseDouble(word);
        };
    }

    private static String id(String url) {
        return url.startsWith("#") ? url.substring(1) : url;
    }
}
