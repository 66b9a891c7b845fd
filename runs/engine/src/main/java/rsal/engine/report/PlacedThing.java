package rsal.engine.report;

import java.util.Locale;
import java.util.Set;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.device.SimulationControl.Thing;

/// What a person can put into a simulated world while a run goes on. Robots run into it and see it.
public enum PlacedThing {
    /// Half a meter each way.
    BOX,

    /// 0.16 m across: grippers can hold it.
    BALL;

    private static final double SIDE = 0.5; // [m]
    private static final double RADIUS = 0.08; // [m]

    /// A name that nobody has: `box-1`.
    public String name(Set<String> taken) {
        String word = name().toLowerCase(Locale.ROOT);
        int number = 1;
        while (taken.contains(word + "-" + number)) {
            number++;
        }
        return word + "-" + number;
    }

    public Thing at(String name, Pose2d mapFromThing) {
        var middle = new Point2d(0, 0);
        return switch (this) {
            case BOX ->
                Thing.of(
                                name,
                                mapFromThing,
                                Solid.standing(Shape.Polygon.of(Footprint.box(SIDE, SIDE, middle)), SIDE),
                                new Rgb(0xd9, 0x90, 0x2f))
                        .asObstacle();
            case BALL ->
                Thing.of(
                                name,
                                mapFromThing,
                                Solid.standing(new Shape.Disc(middle, RADIUS), 2 * RADIUS),
                                new Rgb(0x2f, 0xa8, 0x4f))
                        .asObstacle()
                        .asGrippable();
        };
    }
}
