package rsal.behavior;

import java.util.List;
import rsal.data.Twist2d;

/// What the layers of a pilot decided.
///
/// @param twist velocity that the pilot commands [m/s, rad/s]
/// @param inCharge the uppermost layer that changed the velocity of the layers below it; empty without layers
/// @param opinions of all layers, the lowest first
public record Decision(Twist2d twist, String inCharge, List<Opinion> opinions) {
    public Decision {
        opinions = List.copyOf(opinions);
    }

    /// What a layer wants.
    ///
    /// @param twist what the robot should do as far as this layer and those under it go
    /// @param state what the layer is about, for people; empty when there is nothing to tell
    public record Opinion(String layer, Twist2d twist, String state) {}
}
