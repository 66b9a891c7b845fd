package rsal.foxglove;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import rsal.data.Pose2d;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;

/// What is published to us: a robot is to go somewhere, or is somewhere. Poses may come as ROS has them
/// (`geometry_msgs/Pose`, `PoseStamped`, `PoseWithCovarianceStamped`) or as `foxglove.PoseInFrame`, in JSON.
///
/// @param robot empty where the topic names none
record PublishedGoal(Kind kind, String robot) {
    static final String TOPICS = "/ROBOT/goal and /ROBOT/initialpose; of a run's only robot also /goal_pose,"
            + " /move_base_simple/goal and /initialpose";

    private static final Pattern OF_ROBOT = Pattern.compile("/([^/]+)/(goal|goal_pose|initialpose|pose)");
    private static final Pattern OF_ANY = Pattern.compile("/(goal_pose|move_base_simple/goal|initialpose)");
    private static final double FARTHEST = 1e6; // [m], from the map's origin

    enum Kind {
        GOAL,
        POSE;

        private static Kind of(String topic) {
            return topic.endsWith("pose") && !topic.endsWith("goal_pose") ? POSE : GOAL;
        }
    }

    /// A message that nobody can act on, with a sentence about why.
    static final class Unclear extends Exception {
        private static final long serialVersionUID = 1;

        Unclear(String why) {
            super(why);
        }
    }

    /// What a topic asks for.
    ///
    /// @return empty where it means nothing here
    static Optional<PublishedGoal> of(String topic) {
        if (OF_ANY.matcher(topic).matches()) {
            return Optional.of(new PublishedGoal(Kind.of(topic), ""));
        }
        Matcher named = OF_ROBOT.matcher(topic);
        return named.matches() ? Optional.of(new PublishedGoal(Kind.of(topic), named.group(1))) : Optional.empty();
    }

    /// Where, in `map`.
    ///
    /// @param message JSON
    static Pose2d pose(byte[] message) throws Unclear {
        JsonNode root;
        try {
            root = ClientJson.MAPPER.readTree(message);
        } catch (JacksonException e) {
            throw new Unclear("This is not JSON.");
        }
        String frame = root.path("frame_id")
                .asString(root.path("header").path("frame_id").asString(""));
        if (!frame.isEmpty() && !frame.equals("map") && !frame.equals("/map")) {
            throw new Unclear("Poses are wanted in the frame 'map', not in '%s': choose it as the display frame."
                    .formatted(shortened(frame)));
        }
        JsonNode pose = root;
        while (pose.has("pose")) {
            pose = pose.get("pose");
        }
        JsonNode position = pose.path("position");
        JsonNode orientation = pose.path("orientation");
        double x = number(position.get("x"), "position.x");
        double y = number(position.get("y"), "position.y");
        if (Math.abs(x) > FARTHEST || Math.abs(y) > FARTHEST) {
            throw new Unclear("(%s, %s) is farther away than %.0f m.".formatted(x, y, FARTHEST));
        }
        return new Pose2d(x, y, heading(orientation));
    }

    /// Of a turn about the upward axis; what else is turned is left out.
    private static double heading(JsonNode orientation) throws Unclear {
        double w = number(orientation.get("w"), "orientation.w");
        double z = number(orientation.get("z"), "orientation.z");
        double x = orientation.path("x").asDouble(0);
        double y = orientation.path("y").asDouble(0);
        double length = w * w + x * x + y * y + z * z;
        if (!(length > 1e-6 && length < 1e6)) {
            throw new Unclear("The orientation is not a rotation: its numbers are all 0 or far too large.");
        }
        return Math.atan2(2 * (w * z + x * y), length - 2 * (y * y + z * z));
    }

    private static double number(@Nullable JsonNode node, String what) throws Unclear {
        if (node == null || !node.isNumber()) {
            throw new Unclear("The number '%s' is missing. Poses are like geometry_msgs/PoseStamped.".formatted(what));
        }
        double value = node.asDouble(Double.NaN); // of an integer that no double is as large as
        if (!Double.isFinite(value)) {
            throw new Unclear("The number '%s' is too large.".formatted(what));
        }
        return value;
    }

    static String shortened(String text) {
        return text.length() <= 60 ? text : text.substring(0, 60) + "…";
    }
}
