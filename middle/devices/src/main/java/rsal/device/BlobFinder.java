package rsal.device;

import rsal.data.Blobs;

/// A camera that finds patches of color; an image without any is a reading, too. Frame of its readings:
/// `<robot>/<name>`.
public interface BlobFinder extends Sensor<Blobs> {}
