package rsal.testkit.fake;

import rsal.robot.RobotSystemProvider;
import rsal.testkit.contract.BlobFinderContract;

class FakeBlobFinderTest extends BlobFinderContract {
    @Override
    protected RobotSystemProvider provider() {
        return new FakeProvider();
    }
}
