package rsal.server.description;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.data.Blobs;
import rsal.data.Blobs.Blob;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.data.Stamped;
import rsal.engine.report.Reading;
import rsal.server.message.Messages.BlobInfo;
import rsal.server.message.Messages.CameraView;

class CameraViewsTest {
    private static Reading reading(String device, Object value) {
        return new Reading(device, new Stamped<>(Instant.EPOCH, "base_link", value), Duration.ZERO);
    }

    @Test
    void reportsWhereBlobsAreInWhatACameraSees() {
        var near = new Blob(new Rgb(255, 0, 0), 0, 0, 20, 10, 10, 5, 200, 1.5);
        var far = new Blob(new Rgb(0, 0, 255), 40, 0, 50, 10, 45, 5, 100, Double.NaN);
        var seen = new Blobs(new Pose2d(0.1, 0, 0.5), 80, 60, 0.8, List.of(near, far));

        CameraView camera = CameraViews.of(List.of(reading("laser", "no blobs"), reading("camera", seen)))
                .cameras()
                .getFirst();

        assertThat(camera.name()).isEqualTo("camera");
        assertThat(camera.heading()).isEqualTo(0.5);
        assertThat(camera.blobs()).extracting(BlobInfo::color).containsExactly("#ff0000", "#0000ff");
        BlobInfo left = camera.blobs().getFirst();
        assertThat(left.to()).as("the image's left edge").isCloseTo(0.4, within(1e-9));
        assertThat(left.from()).isCloseTo(0.2, within(1e-9));
        assertThat(left.range()).contains(1.5);
        BlobInfo ahead = camera.blobs().getLast();
        assertThat(ahead.to()).as("ahead").isCloseTo(0, within(1e-9));
        assertThat(ahead.range()).isEmpty();
    }
}
