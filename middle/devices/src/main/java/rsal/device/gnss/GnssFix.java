package rsal.device.gnss;

import rsal.data.Perturbable;
import rsal.data.Point2d;
import rsal.data.Unit;

/// The measured position of a receiver: in the map, whose x axis points east, and on Earth, as
/// `sensor_msgs/NavSatFix` of ROS.
///
/// @param x to the east [m]
/// @param y to the north [m]
/// @param latitude north, WGS 84 [deg]
/// @param longitude east, WGS 84 [deg]
/// @param deviation standard deviation of x and y, as the receiver estimates it [m]
public record GnssFix(
        @Unit("m") double x,
        @Unit("m") double y,
        @Unit("°") double latitude,
        @Unit("°") double longitude,
        @Unit("m") double deviation)
        implements Perturbable<GnssFix> {
    private static final double SEMI_MAJOR_AXIS = 6_378_137; // m; of the ellipsoid of WGS 84
    private static final double SQUARED_ECCENTRICITY = 6.694_379_990_14e-3;

    /// A place in the map. The map counts as flat around its origin, which errs by less than 0.1 m within 1 km.
    ///
    /// @param latitude of the map's origin [deg]
    /// @param longitude of the map's origin [deg]
    public static GnssFix of(Point2d place, double latitude, double longitude, double deviation) {
        return new GnssFix(
                place.x(),
                place.y(),
                latitude + degreesNorth(place.y(), latitude),
                longitude + degreesEast(place.x(), latitude),
                deviation);
    }

    public Point2d position() {
        return new Point2d(x, y);
    }

    @Override
    public GnssFix withError(double range, double left, double angle) {
        return new GnssFix(
                x + range,
                y + left,
                latitude + degreesNorth(left, latitude),
                longitude + degreesEast(range, latitude),
                deviation);
    }

    /// By the radius of curvature in the meridian.
    private static double degreesNorth(double meters, double latitude) {
        double w = w(latitude);
        return Math.toDegrees(meters * w * w * w / (SEMI_MAJOR_AXIS * (1 - SQUARED_ECCENTRICITY)));
    }

    /// By the radius of curvature in the prime vertical.
    private static double degreesEast(double meters, double latitude) {
        return Math.toDegrees(meters * w(latitude) / (SEMI_MAJOR_AXIS * Math.cos(Math.toRadians(latitude))));
    }

    private static double w(double latitude) {
        double sin = Math.sin(Math.toRadians(latitude));
        return Math.sqrt(1 - SQUARED_ECCENTRICITY * sin * sin);
    }
}
