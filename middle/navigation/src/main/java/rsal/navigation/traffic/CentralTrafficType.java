package rsal.navigation.traffic;

import java.util.List;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// One direction at a time through narrow passages, in an order that one robot plans for all.
public final class CentralTrafficType implements TrafficType {
    @Override
    public String key() {
        return "central";
    }

    @Override
    public String description() {
        return "One robot plans for all who goes first through narrow passages; if it is silent, the next one does.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(RightOfWayType.CLAIM_DISTANCE, RightOfWayType.CLOSE_AFTER, RightOfWayType.JUNCTIONS);
    }

    @Override
    public TrafficRule create(Arguments arguments, Participant participant) {
        return RightOfWayType.rule(arguments, participant, 1, CentralAgreement::new);
    }
}
