package rsal.testkit.fake;

import rsal.device.DeviceInfo;
import rsal.device.SensorCore;

/// A device that the fake system gives its turn once a step, after all robots moved.
abstract class FakeSensor<T> extends SensorCore<T> {
    FakeSensor(DeviceInfo info) {
        super(info);
    }

    abstract void sense();

    /// The system is closed; no turn comes any more.
    void shutDown() {}
}
