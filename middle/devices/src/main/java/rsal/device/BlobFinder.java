package rsal.device;

import rsal.data.Blobs;

/// A camera that detects patches of color. An image without any is a reading, too. Frame of its readings:
/// `<robot>/<name>`.
public interface BlobFinder extends Sensor<Blobs> {}
