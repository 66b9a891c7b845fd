package rsal.gazebo;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.data.Point2d;
import rsal.data.Prism;
import rsal.model.xml.Transform;
import rsal.model.xml.Transform.Point;
import rsal.model.xml.XmlElement;
import rsal.scene.Block;
import rsal.scene.Surface;
import rsal.settings.InvalidSettings;

/// Makes blocks of the shapes of models: of collision shapes, and of visual shapes where a model has no others. The
/// latter are seen, and in nobody's way.
final class BodyMaker {
    private static final int MOST_BLOCKS = 200_000;
    private static final int MOST_CORNERS = 2_000; // of a polyline
    private static final int MOST_CORNERS_IN_ALL = 500_000;
    private static final long MOST_MESH_BYTES = 1 << 29; // in all
    private static final double LEVEL = 0.05; // planes that are no higher or lower are the floor [m]

    private final SdfFiles files;
    private final SdfNotes notes;
    private final Map<String, Optional<MeshBounds>> meshes = new HashMap<>();
    private int blocks;
    private int corners;
    private long meshBytes;

    BodyMaker(SdfFiles files, SdfNotes notes) {
        this.files = files;
        this.notes = notes;
    }

    /// @param bodyFromModel where the model's frame is in that of the body
    /// @param height of the body's origin above the floor [m]
    List<Block> blocks(SdfModel model, Transform bodyFromModel, double height) {
        List<Block> solid = blocks(model, bodyFromModel, height, "collision");
        return solid.isEmpty() ? blocks(model, bodyFromModel, height, "visual") : solid;
    }

    private List<Block> blocks(SdfModel model, Transform bodyFromModel, double height, String kind) {
        var made = new ArrayList<Block>();
        boolean solid = kind.equals("collision");
        model.links(link -> {
            List<XmlElement> shapes = link.element().all(kind).toList();
            List<XmlElement> visuals = link.element().all("visual").toList();
            for (int i = 0; i < shapes.size(); i++) {
                XmlElement shape = shapes.get(i);
                Surface plain = SdfColor.of(visualOf(shape, i, visuals))
                        .map(Surface.PLAIN::in)
                        .orElse(Surface.PLAIN);
                Surface surface = solid ? plain : new Surface(plain.color(), false, 1, true, 0, 0, false);
                for (Prism prism : prisms(shape, bodyFromModel.compose(link.place(shape)), height)) {
                    if (++blocks > MOST_BLOCKS) {
                        throw new InvalidSettings(
                                shape.location(), "This world has more than %d shapes.".formatted(MOST_BLOCKS), "");
                    }
                    made.add(new Block(prism, surface));
                }
            }
        });
        return made;
    }

    /// What a shape looks like: the visual of its name, else that at its place in the order, else the first.
    private static Optional<XmlElement> visualOf(XmlElement shape, int index, List<XmlElement> visuals) {
        if (shape.name().equals("visual")) {
            return Optional.of(shape);
        }
        return visuals.stream()
                .filter(visual -> visual.attribute("name").equals(shape.attribute("name")))
                .findFirst()
                .or(() -> Optional.ofNullable(index < visuals.size() ? visuals.get(index) : null))
                .or(() -> visuals.stream().findFirst());
    }

    private List<Prism> prisms(XmlElement shape, Transform in, double height) {
        Optional<XmlElement> geometry =
                shape.first("geometry").flatMap(node -> node.children().stream().findFirst());
        if (geometry.isEmpty()) {
            return List.of();
        }
        XmlElement node = geometry.get();
        return switch (node.name()) {
            case "box" -> {
                double[] size = sizes(node, "size", 3);
                Point half = new Point(size[0] / 2, size[1] / 2, size[2] / 2);
                noteTilt(node, Shadow.isSquare(in));
                yield seen(node, Shadow.box(in, new Point(-half.x(), -half.y(), -half.z()), half));
            }
            case "cylinder", "capsule", "cone" -> {
                noteTilt(node, Shadow.isUpright(in) || Shadow.isLevel(in));
                boolean round = node.name().equals("capsule");
                yield seen(node, Shadow.cylinder(in, size(node, "radius"), size(node, "length"), round));
            }
            case "sphere" -> {
                double radius = size(node, "radius");
                yield seen(node, Shadow.ellipsoid(in, radius, radius, radius));
            }
            case "ellipsoid" -> {
                double[] radii = sizes(node, "radii", 3);
                noteTilt(node, Shadow.isSquare(in));
                yield seen(node, Shadow.ellipsoid(in, radii[0], radii[1], radii[2]));
            }
            case "polyline" ->
                polylines(shape.first("geometry").orElseThrow().all("polyline").toList(), in);
            case "mesh" -> mesh(node, in);
            case "plane" -> {
                notePlane(node, in, height + in.z());
                yield List.of();
            }
            case "empty" -> List.of();
            default -> {
                notes.add(
                        "geometry " + node.name(),
                        node.location(),
                        "A shape of kind '%s' is left out.".formatted(SdfText.shortened(node.name())),
                        "Boxes, cylinders, spheres, polylines and meshes can be read.");
                yield List.of();
            }
        };
    }

    /// What there is of a shape.
    private List<Prism> seen(XmlElement shape, Optional<Prism> made) {
        if (made.isEmpty()) {
            noteFlat(shape);
        }
        return made.stream().toList();
    }

    private void noteFlat(XmlElement shape) {
        notes.add(
                "flat",
                shape.location(),
                "A shape of kind '%s' is left out: it has no area, seen from above.".formatted(shape.name()),
                "");
    }

    private void noteTilt(XmlElement shape, boolean upright) {
        if (!upright) {
            notes.add(
                    "tilted",
                    shape.location(),
                    "A shape of kind '%s' is tilted: what it covers, seen from above, is taken to be solid."
                            .formatted(shape.name()),
                    "");
        }
    }

    private void notePlane(XmlElement plane, Transform in, double height) {
        double[] normal = plane.first("normal").map(node -> node.numbers(3)).orElse(new double[] {0, 0, 1});
        if (Math.abs(in.upwards(normal)) < 0.99) {
            notes.add(
                    "plane",
                    plane.location(),
                    "A plane that is not level is left out.",
                    "Use a thin box as a wall, and a level plane as the floor.");
        } else if (Math.abs(height) > LEVEL) {
            notes.add(
                    "floor",
                    plane.location(),
                    "A plane at the height %.2f m is left out: the floor is at 0.".formatted(height),
                    "");
        }
    }

    private List<Prism> polylines(List<XmlElement> polylines, Transform in) {
        if (polylines.size() > 1) {
            notes.add(
                    "polylines",
                    polylines.getFirst().location(),
                    "A shape has several polylines: holes that they cut are filled.",
                    "");
        }
        var made = new ArrayList<Prism>();
        for (XmlElement polyline : polylines) {
            var outline = new ArrayList<Point2d>();
            for (XmlElement point : polyline.all("point").toList()) {
                double[] xy = point.numbers(2);
                outline.add(new Point2d(xy[0], xy[1]));
            }
            if (outline.size() > 1 && outline.getFirst().equals(outline.getLast())) {
                outline.removeLast();
            }
            corners += outline.size();
            if (outline.size() > MOST_CORNERS || corners > MOST_CORNERS_IN_ALL) {
                throw new InvalidSettings(
                        polyline.location(),
                        "A polyline has more than %d points, or all have more than %d."
                                .formatted(MOST_CORNERS, MOST_CORNERS_IN_ALL),
                        "");
            }
            try {
                Optional<Prism> prism = Shadow.extrusion(in, outline, size(polyline, "height"));
                prism.ifPresentOrElse(made::add, () -> noteFlat(polyline));
                noteTilt(polyline, Shadow.isUpright(in));
            } catch (IllegalArgumentException e) {
                notes.add(
                        "polyline " + polyline.location(),
                        polyline.location(),
                        "A polyline is left out. %s".formatted(e.getMessage()),
                        "");
            }
        }
        return made;
    }

    private List<Prism> mesh(XmlElement mesh, Transform in) {
        String uri = mesh.first("uri").map(XmlElement::text).orElse("");
        double[] scale = mesh.first("scale").map(node -> node.numbers(3)).orElse(new double[] {1, 1, 1});
        if (mesh.first("submesh").isPresent()) {
            notes.add(
                    "submesh " + uri,
                    mesh.location(),
                    "A part ('submesh') of mesh '%s' is left out.".formatted(SdfText.shortened(uri)),
                    "Give its model a collision shape: a box or a cylinder.");
            return List.of();
        }
        Optional<MeshBounds> bounds =
                meshes.computeIfAbsent(mesh.location().file() + " " + uri, _ -> bounds(mesh, uri));
        if (bounds.isEmpty()) {
            notes.add(
                    "mesh " + uri,
                    mesh.location(),
                    "Mesh '%s' is left out: it is not found, or not STL, OBJ or COLLADA."
                            .formatted(SdfText.shortened(uri)),
                    "Give its model a collision shape: a box or a cylinder.");
            return List.of();
        }
        notes.add(
                "meshes",
                mesh.location(),
                "Mesh '%s' is taken for the box around it.".formatted(SdfText.shortened(uri)),
                "");
        Point low = bounds.get().low();
        Point high = bounds.get().high();
        noteTilt(mesh, Shadow.isSquare(in));
        return seen(
                mesh,
                Shadow.box(
                        in,
                        new Point(low.x() * scale[0], low.y() * scale[1], low.z() * scale[2]),
                        new Point(high.x() * scale[0], high.y() * scale[1], high.z() * scale[2])));
    }

    private Optional<MeshBounds> bounds(XmlElement mesh, String uri) {
        if (meshBytes > MOST_MESH_BYTES || SdfFiles.isFar(uri)) {
            return Optional.empty();
        }
        Optional<byte[]> bytes = files.mesh(uri, mesh.location());
        bytes.ifPresent(read -> meshBytes += read.length);
        return bytes.flatMap(read -> MeshBounds.of(uri, read));
    }

    private static double size(XmlElement shape, String name) {
        return sizes(shape, name, 1)[0];
    }

    /// Lengths, of which none is negative.
    private static double[] sizes(XmlElement shape, String name, int count) {
        XmlElement node = shape.first(name)
                .orElseThrow(() -> new InvalidSettings(
                        shape.location(), "This '%s' has no '%s'.".formatted(shape.name(), name), ""));
        double[] sizes = node.numbers(count);
        for (double size : sizes) {
            if (size < 0 || size > 1e5) {
                throw new InvalidSettings(
                        node.location(), "'%s' must be from 0 to 100000 m, not %s.".formatted(name, size), "");
            }
        }
        return sizes;
    }
}
