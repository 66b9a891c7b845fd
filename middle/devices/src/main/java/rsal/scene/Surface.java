package rsal.scene;

import rsal.data.Rgb;

/// What sensors and others make of something solid.
///
/// @param obstacle whether robots run into it
/// @param reflectance how strongly it sends back what range sensors send, 1 is usual; they look through what has
/// a negative one
/// @param blob whether blob finders tell of it; it hides what is behind it all the same
/// @param fiducial its id as a marker; 0 when it is none
/// @param fiducialKey only finders of the same key see the marker
/// @param grippable whether grippers can hold it
public record Surface(
        Rgb color,
        boolean obstacle,
        double reflectance,
        boolean blob,
        int fiducial,
        int fiducialKey,
        boolean grippable) {

    /// Gray, in everybody's way, seen by all, no marker, not to be held.
    public static final Surface PLAIN = new Surface(new Rgb(0x80, 0x80, 0x80), true, 1, true, 0, 0, false);

    public Surface in(Rgb other) {
        return new Surface(other, obstacle, reflectance, blob, fiducial, fiducialKey, grippable);
    }

    /// The same, which finders of key 0 know as that marker.
    ///
    /// @param id 0: it is none
    public Surface withMarker(int id) {
        return new Surface(color, obstacle, reflectance, blob, id, 0, grippable);
    }

    /// The same, of which blob finders don't tell.
    public Surface withoutBlobs() {
        return new Surface(color, obstacle, reflectance, false, fiducial, fiducialKey, grippable);
    }

    public boolean seenByRangers() {
        return reflectance >= 0;
    }
}
