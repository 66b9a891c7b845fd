package rsal.gazebo;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Optional;
import java.util.StringTokenizer;
import rsal.model.xml.Transform.Point;

/// The box around a mesh, along the axes of its file: STL as text or bytes, OBJ, and COLLADA.
///
/// @param low corner [m]
/// @param high corner [m]
record MeshBounds(Point low, Point high) {
    private static final int HEADER = 84; // bytes of a binary STL before its triangles
    private static final int TRIANGLE = 50; // bytes

    /// What is read of a mesh.
    ///
    /// @param name of its file
    /// @return empty when it is none of these formats, or has no corner that can be read
    static Optional<MeshBounds> of(String name, byte[] mesh) {
        String lower = name.toLowerCase(Locale.ROOT);
        if (lower.endsWith(".stl")) {
            return isBinary(mesh) ? binary(mesh) : text(mesh, "vertex");
        }
        if (lower.endsWith(".dae")) {
            return ColladaMesh.bounds(mesh);
        }
        return lower.endsWith(".obj") ? text(mesh, "v") : Optional.empty();
    }

    /// Text begins with "solid"; so do some binary files, which are as long as their number of triangles says.
    private static boolean isBinary(byte[] mesh) {
        return mesh.length >= HEADER
                && mesh.length
                        == HEADER
                                + (long) TRIANGLE
                                        * Integer.toUnsignedLong(bytes(mesh).getInt(HEADER - 4));
    }

    private static ByteBuffer bytes(byte[] mesh) {
        return ByteBuffer.wrap(mesh).order(ByteOrder.LITTLE_ENDIAN);
    }

    private static Optional<MeshBounds> binary(byte[] mesh) {
        ByteBuffer bytes = bytes(mesh);
        var extent = new MeshExtent();
        for (int at = HEADER; at + TRIANGLE <= mesh.length; at += TRIANGLE) {
            for (int corner = 0; corner < 3; corner++) {
                int from = at + 12 + 12 * corner; // after the normal
                extent.add(bytes.getFloat(from), bytes.getFloat(from + 4), bytes.getFloat(from + 8));
            }
        }
        return extent.bounds();
    }

    /// @param word with which lines of corners begin
    private static Optional<MeshBounds> text(byte[] mesh, String word) {
        var extent = new MeshExtent();
        new String(mesh, StandardCharsets.ISO_8859_1).lines().forEach(line -> {
            var words = new StringTokenizer(line);
            if (words.countTokens() >= 4 && words.nextToken().equalsIgnoreCase(word)) {
                try {
                    extent.add(number(words), number(words), number(words));
                } catch (NumberFormatException _) {
                    // no corner
                }
            }
        });
        return extent.bounds();
    }

    private static double number(StringTokenizer words) {
        return Double.parseDouble(words.nextToken());
    }
}
