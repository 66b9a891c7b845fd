package rsal.server.http;

import io.javalin.http.Context;
import io.javalin.http.Header;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import rsal.data.OccupancyGrid;
import rsal.engine.report.Snapshot;
import rsal.map.RosMap;

/// Answers with maps: as cells for the page, and as files that ROS and scenarios read.
public final class Grids {
    private static final int HEADER = 2 * Integer.BYTES + 3 * Double.BYTES;

    private Grids() {}

    public static void answer(Context request, OccupancyGrid drawn) {
        Http.answerPacked(request, Http.packed(bytes(drawn)));
    }

    /// As [rsal.server.message.Messages.DrawnMap] has it.
    private static byte[] bytes(OccupancyGrid drawn) {
        ByteBuffer bytes = ByteBuffer.allocate(HEADER + drawn.cells().length).order(ByteOrder.LITTLE_ENDIAN);
        bytes.putInt(drawn.width()).putInt(drawn.height());
        bytes.putDouble(drawn.resolution()).putDouble(drawn.originX()).putDouble(drawn.originY());
        return bytes.put(drawn.cells()).array();
    }

    public static void answerFiles(Context request, String robot, OccupancyGrid drawn) throws IOException {
        var packed = new ByteArrayOutputStream();
        try (var zip = new ZipOutputStream(packed)) {
            zip.putNextEntry(new ZipEntry(robot + ".pgm"));
            zip.write(RosMap.pgm(drawn));
            zip.putNextEntry(new ZipEntry(robot + ".yaml"));
            zip.write(RosMap.yaml(drawn, robot + ".pgm").getBytes(StandardCharsets.UTF_8));
        }
        request.header(Header.CONTENT_DISPOSITION, "attachment; filename=\"%s-map.zip\"".formatted(robot));
        request.contentType("application/zip").result(packed.toByteArray());
    }

    /// A map that the `robot` has drawn: by its `device`, or the first where none is named.
    public static Optional<OccupancyGrid> drawn(Snapshot snapshot, Context request) {
        String device = Http.parameter(request, "device");
        return snapshot.robots().stream()
                .filter(view -> view.id().equals(Http.parameter(request, "robot")))
                .flatMap(view -> view.maps().stream())
                .filter(drawn -> device.isEmpty() || device.equals(drawn.device()))
                .map(drawn -> drawn.map().value())
                .findFirst();
    }
}
