package rsal.cli.show;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import rsal.cli.terminal.FileError;
import rsal.cli.terminal.TextTable;
import rsal.navigation.rooms.MapRegion;
import rsal.navigation.rooms.RegionKind;
import rsal.navigation.rooms.RoomGate;
import rsal.navigation.rooms.RoomMap;
import rsal.settings.Problem;

/// The rooms of a map, for `rsal show --rooms`.
///
/// @param map its name or file
/// @param places for a team, when they are asked for
/// @param image where they are drawn
/// @param warnings of what in the map's files has no effect, or may not mean what their author thinks
record ShownRooms(
        String map,
        List<MapRegion> regions,
        List<RoomGate> gates,
        Optional<ShownPlaces> places,
        String image,
        List<FileError> warnings) {
    static ShownRooms of(
            String map, RoomMap rooms, Optional<ShownPlaces> places, String image, List<Problem> warnings) {
        return new ShownRooms(map, rooms.regions(), rooms.gates(), places, image, FileError.of(warnings));
    }

    private long count(RegionKind kind) {
        return regions.stream().filter(region -> region.kind() == kind).count();
    }

    private static String count(long count, String one, String many) {
        return count == 1 ? "1 " + one : count + " " + many;
    }

    /// For people.
    String text() {
        var text = new StringBuilder();
        text.append("%s: %s, %s, %s, %s%n%n"
                .formatted(
                        map,
                        count(count(RegionKind.ROOM), "room", "rooms"),
                        count(count(RegionKind.CORRIDOR), "corridor", "corridors"),
                        count(count(RegionKind.CLOSET), "closet", "closets"),
                        count(gates.size(), "gate", "gates")));
        var table = new TextTable("  ");
        table.row("region", "kind", "area", "middle", "gates to");
        for (MapRegion region : regions) {
            var to = new StringBuilder();
            for (RoomGate gate : gates) {
                if (gate.leadsTo(region.number())) {
                    to.append(to.isEmpty() ? "" : ", ")
                            .append(String.format(
                                    Locale.ROOT, "%d (%.2f m)", gate.across(region.number()), gate.width()));
                }
            }
            table.row(
                    String.valueOf(region.number()),
                    region.kind().name().toLowerCase(Locale.ROOT),
                    String.format(Locale.ROOT, "%.1f m²", region.area()),
                    String.format(
                            Locale.ROOT,
                            "(%.2f, %.2f)",
                            region.middle().x(),
                            region.middle().y()),
                    to.toString());
        }
        text.append(table);
        places.ifPresent(shown -> text.append(shown.text()));
        return text.toString();
    }
}
