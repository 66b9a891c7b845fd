package rsal.navigation.traffic;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.navigation.passage.Passages;
import rsal.navigation.traffic.Mates.Mate;
import rsal.navigation.traffic.TrafficReport.Claim;
import rsal.navigation.traffic.TrafficReport.Follower;

/// Mutual exclusion in narrow passages without a master: Ricart, Agrawala: An optimal algorithm for mutual exclusion in
/// computer networks, CACM 24 (1981), with tickets after Lamport (1978).
///
/// Differs in that an answer is a report of the whole state and says which tickets it knows of, so that messages may be
/// lost and come twice; that a robot which does not answer for 3 s is taken for absent, unless it has the
/// passage; and that the one that has it may take followers in its direction along.
final class Tickets implements Agreement {
    private static final Duration LISTENING = Duration.ofMillis(500); // before it goes, for who was not heard yet
    private static final Duration DEAF = Duration.ofSeconds(10); // who is heard, but does not answer for so long

    private final Team team;
    private final List<Follower> followers = new ArrayList<>();

    Tickets(Team team) {
        this.team = team;
    }

    @Override
    public void look(
            Instant now, Pose2d mapFromBase, Passages known, List<Point2d> mapFromPath, @Nullable OwnClaim own) {
        followers.removeIf(follower -> team.mates().isDone(follower.robot(), follower.ticket()));
        if (own != null && own.isHeld && !isFollower(own)) {
            invite(own);
        }
    }

    @Override
    public List<Follower> followers() {
        return followers;
    }

    @Override
    public void leaveFollowers() {
        followers.clear();
    }

    @Override
    public PassageAccess access(Instant now, OwnClaim wanted) {
        boolean invited = team.mates().all().stream()
                .flatMap(mate -> mate.report.followers().stream())
                .anyMatch(
                        follower -> follower.robot().equals(team.self().robot()) && follower.ticket() == wanted.ticket);
        boolean allAnswered = !now.isBefore(wanted.since.plus(LISTENING));
        for (Mate mate : team.mates().all()) {
            if (isTaken(wanted, mate, invited)) {
                return PassageAccess.TAKEN;
            }
            allAnswered &= hasAnswered(now, wanted, mate);
        }
        return invited || allAnswered ? PassageAccess.FREE : PassageAccess.ASKED;
    }

    private boolean isTaken(OwnClaim wanted, Mate mate, boolean invited) {
        for (Follower follower : mate.report.followers()) {
            boolean counts = !follower.robot().equals(team.self().robot())
                    && !team.mates().isDone(follower.robot(), follower.ticket())
                    && team.neighbors().meets(wanted, follower.passages());
            if (counts && !(invited && GateNeighbors.isSame(follower.entry(), wanted.entry))) {
                return true;
            }
        }
        Claim other = mate.report.claim().orElse(null);
        if (other == null || !team.neighbors().meets(wanted, other.passages())) {
            return false;
        }
        if (invited) {
            return other.isHeld() && !GateNeighbors.isSame(other.entry(), wanted.entry);
        }
        return other.isHeld() || wanted.isAfter(other, mate.robot, team.self().robot());
    }

    /// Whether a robot knows of a claim, or is not there any more.
    private boolean hasAnswered(Instant now, OwnClaim wanted, Mate mate) {
        if (mate.report.heard().getOrDefault(team.self().robot(), 0L) >= wanted.ticket) {
            return true;
        }
        Instant from = mate.heardAt.isAfter(wanted.since) ? mate.heardAt : wanted.since;
        return Duration.between(from, now).compareTo(Team.ABSENT) > 0
                || Duration.between(wanted.since, now).compareTo(DEAF) > 0;
    }

    /// Takes along who comes behind in the same direction.
    private void invite(OwnClaim held) {
        int most = Math.max(team.batch(), held.robotsPerDirection());
        boolean othersWait = false;
        for (Mate mate : team.mates().all()) {
            Claim other = mate.report.claim().orElse(null);
            othersWait |= other != null
                    && !other.isHeld()
                    && team.neighbors().meets(held, other.passages())
                    && !GateNeighbors.isSame(other.entry(), held.entry);
        }
        for (Mate mate : team.mates().all()) {
            Claim other = mate.report.claim().orElse(null);
            if (other == null) {
                continue;
            }
            boolean comes = !other.isHeld()
                    && team.neighbors().meets(held, other.passages())
                    && GateNeighbors.isSame(other.entry(), held.entry)
                    && mate.report.done() < other.ticket()
                    && followers.stream().noneMatch(follower -> follower.robot().equals(mate.robot))
                    && mate.report.mapFromBase().position().distanceTo(held.entry) < team.claimDistance();
            if (comes && (!othersWait || followers.size() < most - 1)) {
                followers.add(new Follower(mate.robot, other.ticket(), other.passages(), other.entry()));
                team.report().run();
            }
        }
    }

    private boolean isFollower(OwnClaim held) {
        return team.mates().all().stream()
                .flatMap(mate -> mate.report.followers().stream())
                .anyMatch(follower -> follower.robot().equals(team.self().robot()) && follower.ticket() == held.ticket);
    }
}
