package rsal.cli.show;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.SplittableRandom;
import rsal.cli.terminal.TextTable;
import rsal.data.PlaceObjective;
import rsal.data.Point2d;
import rsal.navigation.rooms.RoomMap;
import rsal.navigation.spread.ReachableSpace;
import rsal.navigation.spread.Spreader;
import rsal.navigation.spread.TeamMeasure;
import rsal.navigation.spread.TeamPlaces;

/// Places for a team on a map by each objective, for `rsal show --rooms --places`.
///
/// @param number of robots
record ShownPlaces(int number, List<Choice> choices) {
    private static final double CLEARANCE = 0.4; // m, as agents ask for by default

    /// @param objective one of [PlaceObjective#keys]
    /// @param places in the map frame [m]
    record Choice(String objective, List<Point2d> places, Measure measure) {}

    /// A [TeamMeasure] whose numbers are all finite.
    ///
    /// @param least empty for one place
    record Measure(int rooms, int inCorridors, Optional<Double> least, double greatest, double mean) {
        static Measure of(TeamMeasure measure) {
            return new Measure(
                    measure.rooms(),
                    measure.inCorridors(),
                    Optional.of(measure.least()).filter(Double::isFinite),
                    measure.greatest(),
                    measure.mean());
        }
    }

    /// On the largest part of the map.
    ///
    /// @throws IllegalArgumentException when there is no room for so many
    static ShownPlaces of(RoomMap rooms, int number) {
        ReachableSpace ground = ReachableSpace.largest(rooms.map(), CLEARANCE);
        var team = new TeamPlaces(ground);
        var choices = new ArrayList<Choice>();
        for (PlaceObjective objective : PlaceObjective.values()) {
            List<Point2d> places = objective == PlaceObjective.EVENLY
                    ? new Spreader(ground, number)
                            .spread(new SplittableRandom(1), _ -> {})
                            .places()
                    : team.choose(number, objective);
            choices.add(new Choice(objective.key(), places, Measure.of(TeamMeasure.of(ground, rooms, places))));
        }
        return new ShownPlaces(number, List.copyOf(choices));
    }

    /// Those of the objective 'rooms'.
    List<Point2d> roomPlaces() {
        return choices.stream()
                .filter(choice -> choice.objective.equals(PlaceObjective.ROOMS.key()))
                .findFirst()
                .map(Choice::places)
                .orElse(List.of());
    }

    /// For people.
    String text() {
        var table = new TextTable("  ");
        table.row("objective", "rooms", "in corridors", "least apart", "greatest distance", "mean distance");
        for (Choice choice : choices) {
            Measure measure = choice.measure;
            table.row(
                    choice.objective,
                    String.valueOf(measure.rooms()),
                    String.valueOf(measure.inCorridors()),
                    measure.least().map(ShownPlaces::meters).orElse("-"),
                    meters(measure.greatest()),
                    meters(measure.mean()));
        }
        return "%nPlaces for %d robot%s%n%n%s".formatted(number, number == 1 ? "" : "s", table);
    }

    private static String meters(double length) {
        return String.format(Locale.ROOT, "%.1f m", length);
    }
}
