package rsal.gazebo;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import rsal.model.xml.XmlElement;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// Finds the models of a world, those that it includes from other files, too.
final class ModelReader {
    private static final int DEEPEST = 16; // models in models
    private static final int MOST = 10_000; // models
    private static final Set<String> EVERYWHERE = Set.of("ground_plane", "sun"); // floor and light, nothing solid

    private final SdfFiles files;
    private final SdfNotes notes;
    private int count;

    ModelReader(SdfFiles files, SdfNotes notes) {
        this.files = files;
        this.notes = notes;
    }

    /// The models of a `world` or `model`, in their order.
    List<SdfModel> models(XmlElement scope) {
        return models(scope, 0);
    }

    private List<SdfModel> models(XmlElement scope, int depth) {
        if (depth > DEEPEST) {
            throw new InvalidSettings(
                    scope.location(),
                    "Models are nested deeper than %d.".formatted(DEEPEST),
                    "Maybe one includes itself.");
        }
        var models = new ArrayList<SdfModel>();
        var names = new HashSet<String>();
        for (XmlElement child : scope.children()) {
            if (child.name().equals("model")) {
                models.add(model(child, child, names, depth));
            } else if (child.name().equals("include")) {
                included(child).ifPresent(model -> models.add(model(child, model, names, depth)));
            }
        }
        return models;
    }

    /// @param place the model itself, or where it is included
    private SdfModel model(XmlElement place, XmlElement model, Set<String> names, int depth) {
        if (++count > MOST) {
            throw new InvalidSettings(place.location(), "This world has more than %d models.".formatted(MOST), "");
        }
        boolean included = place.name().equals("include");
        String make = model.attribute("name");
        String reported = included ? place.first("name").map(XmlElement::text).orElse(make) : make;
        List<SdfModel> inner = models(model, depth + 1);
        return new SdfModel(
                free(reported.isEmpty() ? "model" : reported, names),
                make,
                model,
                place.location(),
                included ? place.first("pose").or(() -> model.first("pose")) : model.first("pose"),
                placementFrame(place, model, included),
                isStatic(model) || (included && isStatic(place)),
                included && Poses.isTrue(place.attribute("merge")),
                inner,
                new SdfFrames(model, inner));
    }

    private static String placementFrame(XmlElement place, XmlElement model, boolean included) {
        return included && place.first("placement_frame").isPresent()
                ? place.first("placement_frame").map(XmlElement::text).orElse("")
                : model.attribute("placement_frame");
    }

    private static boolean isStatic(XmlElement element) {
        return element.first("static")
                .filter(reported -> Poses.isTrue(reported.text()))
                .isPresent();
    }

    /// As Gazebo does with a name that there is already.
    private static String free(String wanted, Set<String> names) {
        String name = wanted;
        for (int i = 1; !names.add(name); i++) {
            name = wanted + "_" + i;
        }
        return name;
    }

    private Optional<XmlElement> included(XmlElement include) {
        String uri = include.first("uri").map(XmlElement::text).orElse("");
        Location at = include.location();
        String last = uri.replaceFirst("/+$", "")
                .replaceFirst(".*/", "")
                .toLowerCase(Locale.ROOT)
                .replace(' ', '_');
        if (EVERYWHERE.contains(last)) {
            return Optional.empty();
        }
        if (SdfFiles.isFar(uri)) {
            notes.add(
                    "far",
                    at,
                    "'%s' is left out: nothing is fetched from a network.".formatted(SdfText.shortened(uri)),
                    "Download it into a folder beside the world, and include it by 'model://FOLDER'.");
            return Optional.empty();
        }
        Optional<XmlElement> file = files.model(uri, at);
        if (file.isEmpty()) {
            notes.add(
                    "missing " + uri,
                    at,
                    "'%s' is left out: it is not found.".formatted(SdfText.shortened(uri)),
                    "Put its folder beside the world, or name the folder it is in by GZ_SIM_RESOURCE_PATH.");
            return Optional.empty();
        }
        Optional<XmlElement> model = file.filter(
                        root -> root.name().equals("sdf") || root.name().equals("gazebo"))
                .flatMap(root -> root.first("model"));
        if (model.isEmpty()) {
            notes.add(
                    "no model " + uri,
                    at,
                    "'%s' is left out: it holds no model in SDF.".formatted(SdfText.shortened(uri)),
                    "");
        }
        return model;
    }
}
