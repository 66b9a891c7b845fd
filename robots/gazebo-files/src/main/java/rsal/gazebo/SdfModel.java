package rsal.gazebo;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import rsal.model.xml.Transform;
import rsal.model.xml.XmlElement;
import rsal.settings.Location;

/// A model of a world, or one in another: its description, and where it is told to be.
///
/// @param name in what it is part of
/// @param make name that its description gives it: models that are included twice have the same one
/// @param element its description
/// @param location where it is, or is included
/// @param pose relative to what it is part of, when it is told
/// @param placementFrame which of its frames the pose is of; empty for its own
/// @param isStatic whether it stays where it is
/// @param merged whether its names are those of what it is part of
/// @param models that are part of it
/// @param frames that are in it
record SdfModel(
        String name,
        String make,
        XmlElement element,
        Location location,
        Optional<XmlElement> pose,
        String placementFrame,
        boolean isStatic,
        boolean merged,
        List<SdfModel> models,
        SdfFrames frames) {

    SdfModel {
        models = List.copyOf(models);
    }

    /// A link, with its place in the frame of the model that was asked for.
    ///
    /// @param name with those of the models in between, `arm::hand`
    record Link(String name, XmlElement element, Transform modelFromLink, Transform modelFromOwner, SdfFrames frames) {
        /// Where something of the link is, in the frame of the model that was asked for.
        Transform place(XmlElement part) {
            Optional<XmlElement> pose = part.first("pose");
            boolean elsewhere = pose.filter(
                            reported -> !reported.attribute("relative_to").isEmpty())
                    .isPresent();
            return elsewhere ? modelFromOwner.compose(frames.place(pose, "")) : modelFromLink.compose(Poses.of(pose));
        }
    }

    /// All its links, and those of the models in it.
    void links(Consumer<Link> consumer) {
        links("", Transform.NONE, consumer);
    }

    private void links(String prefix, Transform rootFromModel, Consumer<Link> consumer) {
        element.all("link")
                .forEach(link -> consumer.accept(new Link(
                        prefix + link.attribute("name"),
                        link,
                        rootFromModel.compose(frames.find(link.attribute("name"), Optional.of(link.location()))),
                        rootFromModel,
                        frames)));
        for (SdfModel model : models) {
            Transform rootFromInner = rootFromModel.compose(frames.find(model.name(), Optional.of(model.location())));
            model.links(model.merged() ? prefix : prefix + model.name() + "::", rootFromInner, consumer);
        }
    }

    /// All elements of a kind that it and the models in it have: `plugin`, `joint`.
    List<XmlElement> all(String kind) {
        return java.util.stream.Stream.concat(
                        element.all(kind), models.stream().flatMap(model -> model.all(kind).stream()))
                .toList();
    }
}
