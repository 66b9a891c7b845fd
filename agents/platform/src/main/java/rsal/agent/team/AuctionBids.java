package rsal.agent.team;

import java.util.Optional;
import rsal.agent.MessageContent;
import rsal.agent.Topic;
import rsal.agent.message.MessageCheck;

/// What a member says to the other members of an auction. Only the newest of each member counts.
///
/// @param team name of the agent that has the jobs
/// @param auction number of its call
/// @param takesPart whether the sender bids at all
/// @param said its bids
public record AuctionBids(String team, int auction, boolean takesPart, Allocator.Said said) implements MessageContent {
    public static final Topic<AuctionBids> TOPIC = new Topic<>("auction-bids", AuctionBids.class);

    public AuctionBids {
        MessageCheck.given("team", team);
        MessageCheck.given("bids", said);
    }

    @Override
    public String words() {
        return takesPart
                ? "auction %d of '%s': %d bids"
                        .formatted(auction, team, said.bids().size())
                : "auction %d of '%s': takes no part".formatted(auction, team);
    }

    /// It is said again and again.
    @Override
    public Optional<String> eventKind() {
        return Optional.empty();
    }
}
