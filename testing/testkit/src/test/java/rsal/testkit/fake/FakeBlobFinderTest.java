package rsal.testkit.fake;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import rsal.data.Blobs.Blob;
import rsal.data.Rgb;
import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.BlobFinderContract;

class FakeBlobFinderTest extends BlobFinderContract {
    @Override
    protected RobotSystemProvider provider() {
        return new FakeProvider();
    }

    @Test
    void showsWhatATestWants() {
        var blob = new Blob(new Rgb(1, 2, 3), 0, 0, 10, 10, 5, 5, 100, 1);
        robot().require(FakeBlobFinder.class).show(blob);
        assertThat(reading().blobs()).containsExactly(blob);
    }
}
