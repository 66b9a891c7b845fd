package rsal.gazebo;

import java.util.Optional;
import rsal.model.xml.Transform;
import rsal.model.xml.XmlElement;
import rsal.settings.InvalidSettings;

/// Reads a `pose`: `x y z roll pitch yaw`, or with a quaternion.
final class Poses {
    private static final double FARTHEST = 1e6; // [m, rad]; a world is at most 100 km large

    private Poses() {}

    /// @param pose empty where there is none
    static Transform of(Optional<XmlElement> pose) {
        return pose.map(Poses::of).orElse(Transform.NONE);
    }

    private static Transform of(XmlElement pose) {
        if (pose.text().isEmpty()) {
            return Transform.NONE;
        }
        boolean quaternion = pose.attribute("rotation_format").equals("quat_xyzw");
        double[] n = pose.numbers(quaternion ? 7 : 6);
        for (double number : n) {
            if (Math.abs(number) > FARTHEST) {
                throw new InvalidSettings(
                        pose.location(), "This pose has %s, which is too far away.".formatted(number), "");
            }
        }
        double[] xyz = {n[0], n[1], n[2]};
        if (quaternion) {
            if (n[3] * n[3] + n[4] * n[4] + n[5] * n[5] + n[6] * n[6] < 1e-12) {
                throw new InvalidSettings(
                        pose.location(), "This pose has the quaternion 0, which is not a rotation.", "");
            }
            return Transform.ofQuaternion(xyz, new double[] {n[3], n[4], n[5], n[6]});
        }
        double unit = isTrue(pose.attribute("degrees")) ? Math.PI / 180 : 1;
        return Transform.of(xyz, new double[] {n[3] * unit, n[4] * unit, n[5] * unit});
    }

    /// As SDF writes yes and no.
    static boolean isTrue(String text) {
        return text.equalsIgnoreCase("true") || text.equals("1");
    }
}
