package rsal.gazebo;

import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import rsal.model.xml.Transform;
import rsal.model.xml.XmlElement;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Suggestion;

/// The frames that names stand for in a world or in a model: those of its links, joints, models and frames, each
/// placed relative to another one.
final class SdfFrames {
    private static final int MOST_IN_A_ROW = 100; // frames, each relative to the next

    private final Map<String, Entry> entries = new LinkedHashMap<>();
    private final List<SdfModel> models;
    private final Map<String, Transform> found = new HashMap<>();
    private final Set<String> open = new HashSet<>();

    /// @param usual what it is relative to when it says nothing
    /// @param model when it is one
    private record Entry(Location location, Optional<XmlElement> pose, String usual, Optional<SdfModel> model) {}

    /// @param scope a `world` or a `model`
    /// @param models in it
    SdfFrames(XmlElement scope, List<SdfModel> models) {
        this.models = models;
        for (XmlElement child : scope.children()) {
            Optional<XmlElement> pose = child.first("pose");
            switch (child.name()) {
                case "link" -> add(child, pose, "");
                case "frame" -> add(child, pose, child.attribute("attached_to"));
                case "joint" ->
                    add(child, pose, child.first("child").map(XmlElement::text).orElse(""));
                default -> {} // models are added below; nothing else is a frame
            }
        }
        for (SdfModel model : models) {
            entries.putIfAbsent(model.name(), new Entry(model.location(), model.pose(), "", Optional.of(model)));
        }
    }

    private void add(XmlElement frame, Optional<XmlElement> pose, String usual) {
        entries.putIfAbsent(frame.attribute("name"), new Entry(frame.location(), pose, usual, Optional.empty()));
    }

    /// Where what a `pose` places is, in the frame of the world or model.
    ///
    /// @param usual frame that it is relative to when it says nothing
    Transform place(Optional<XmlElement> pose, String usual) {
        String relative =
                pose.map(reported -> reported.attribute("relative_to")).orElse("");
        Transform in = relative.isEmpty() && usual.isEmpty()
                ? Transform.NONE
                : find(relative.isEmpty() ? usual : relative, pose.map(XmlElement::location));
        return in.compose(Poses.of(pose));
    }

    /// Where a frame is, in that of the world or model.
    ///
    /// @param askedAt where it is named
    /// @throws InvalidSettings when there is none, or it is relative to itself
    Transform find(String name, Optional<Location> askedAt) {
        if (name.isEmpty() || name.equals("__model__") || name.equals("world") || name.equals("__root__")) {
            return Transform.NONE;
        }
        Transform known = found.get(name);
        if (known != null) {
            return known;
        }
        Entry entry = entries.get(name);
        Transform where = entry == null ? inside(name, askedAt) : resolve(name, entry);
        found.put(name, where);
        return where;
    }

    private Transform resolve(String name, Entry entry) {
        if (open.size() >= MOST_IN_A_ROW || !open.add(name)) {
            throw new InvalidSettings(
                    entry.location(), "Frame '%s' is relative to itself, or to too many others.".formatted(name), "");
        }
        Transform placed = place(entry.pose(), entry.usual());
        open.remove(name);
        return entry.model()
                .filter(model -> !model.placementFrame().isEmpty())
                .map(model -> placed.compose(model.frames()
                        .find(model.placementFrame(), Optional.of(entry.location()))
                        .inverse()))
                .orElse(placed);
    }

    /// A frame of one of the models: `arm::hand`, or by its own name when the model is merged with this one.
    private Transform inside(String name, Optional<Location> askedAt) {
        int colons = name.indexOf("::");
        if (colons > 0) {
            Entry entry = entries.get(name.substring(0, colons));
            if (entry != null && entry.model().isPresent()) {
                return find(name.substring(0, colons), askedAt)
                        .compose(entry.model().get().frames().find(name.substring(colons + 2), askedAt));
            }
        }
        for (SdfModel model : models) {
            if (model.merged() && model.frames().entries.containsKey(name)) {
                return find(model.name(), askedAt).compose(model.frames().find(name, askedAt));
            }
        }
        throw new InvalidSettings(
                askedAt.orElse(Location.of("")),
                "There is no frame '%s' here.".formatted(name),
                Suggestion.among(name, entries.keySet()));
    }
}
