package rsal.model.urdf;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.model.xml.Transform;
import rsal.model.xml.XmlElement;
import rsal.settings.InvalidSettings;
import rsal.settings.Suggestion;

/// What a URDF file says: links, where they are in the frame of the first one while all joints are at 0, and
/// the joints that lead to them.
///
/// @param links by name, in their order in the file
/// @param joints by the link that each leads to
/// @param rootFromLinks by link
record RobotDescription(
        String name,
        XmlElement robot,
        Map<String, XmlElement> links,
        Map<String, XmlElement> joints,
        Map<String, Transform> rootFromLinks) {
    private static final int MOST = 100_000; // elements

    /// @throws InvalidSettings when the file is no URDF, or its links are no tree
    static RobotDescription read(String text, String file) {
        XmlElement robot =
                XmlElement.read(text, file, MOST, "A .xacro file must be expanded first: xacro FILE > ROBOT.urdf.");
        if (!robot.name().equals("robot")) {
            throw new InvalidSettings(
                    robot.location(),
                    "This is not a robot description: it begins with '%s', not 'robot'.".formatted(robot.name()),
                    "");
        }
        var links = new LinkedHashMap<String, XmlElement>();
        robot.all("link").forEach(link -> links.put(link.attribute("name"), link));
        if (links.isEmpty()) {
            throw new InvalidSettings(robot.location(), "This robot description has no 'link'.", "");
        }
        var joints = new LinkedHashMap<String, XmlElement>();
        for (XmlElement joint : robot.all("joint").toList()) {
            String child = end(joint, "child", links);
            end(joint, "parent", links);
            if (joints.put(child, joint) != null) {
                throw new InvalidSettings(joint.location(), "Two joints lead to link '%s'.".formatted(child), "");
            }
        }
        var where = new HashMap<String, Transform>();
        for (String link : links.keySet()) {
            where.put(link, rootFromLink(link, joints, new ArrayList<>()));
        }
        return new RobotDescription(robot.attribute("name"), robot, links, joints, where);
    }

    private static String end(XmlElement joint, String which, Map<String, XmlElement> links) {
        String link = joint.first(which).map(end -> end.attribute("link")).orElse("");
        if (!links.containsKey(link)) {
            throw new InvalidSettings(
                    joint.location(),
                    "Joint '%s' has no link '%s' as its %s.".formatted(joint.attribute("name"), link, which),
                    Suggestion.among(link, links.keySet()));
        }
        return link;
    }

    private static Transform rootFromLink(String link, Map<String, XmlElement> joints, List<String> below) {
        XmlElement joint = joints.get(link);
        if (joint == null) {
            return Transform.NONE;
        }
        if (below.contains(link)) {
            throw new InvalidSettings(joint.location(), "The links around '%s' form a circle.".formatted(link), "");
        }
        below.add(link);
        String parent = joint.first("parent").orElseThrow().attribute("link");
        return rootFromLink(parent, joints, below).compose(Transform.of(joint));
    }

    Transform rootFromLink(String link) {
        return rootFromLinks.getOrDefault(link, Transform.NONE);
    }

    Optional<XmlElement> jointTo(String link) {
        return Optional.ofNullable(joints.get(link));
    }
}
