package rsal.agents.patrol.strategy;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import rsal.data.Point2d;

/// Places and edges as files `.graph` of patrolling_sim have them: numbers between white space. First the
/// number of places, the map's width and height [pixels], its resolution [m per pixel] and, in some files, an
/// offset x and y [m]; then for each place its number, x and y [pixels], the number of its neighbors, and for
/// each of these its number, a direction as `NE`, and the length of the edge [pixels].
///
/// @param mapFromPlaces x and y of the places, by pixels, resolution and offset [m]
/// @param edges each pair of neighbors once; where its two lengths differ, the shorter
public record GraphFile(List<Point2d> mapFromPlaces, List<PatrolGraph.Edge> edges) {
    private static final int LONGEST = 1_000_000; // characters
    private static final int MOST_NEIGHBORS = 100;
    private static final double MOST_PIXELS = 1e6;
    private static final Pattern DIRECTION = Pattern.compile("[A-Za-z]{1,3}");
    private static final Pattern WHITE = Pattern.compile("\\s+");

    public GraphFile {
        mapFromPlaces = List.copyOf(mapFromPlaces);
        edges = List.copyOf(edges);
    }

    /// @throws IllegalArgumentException with a sentence that names the place and the value, when the text is no
    /// graph
    public static GraphFile read(String text) {
        if (text.length() > LONGEST) {
            throw new IllegalArgumentException(
                    "A graph has at most %d characters, not %d.".formatted(LONGEST, text.length()));
        }
        String[] words = WHITE.split(text.strip());
        if (text.isBlank()) {
            throw new IllegalArgumentException("The graph is empty. It begins with the number of places.");
        }
        var withOffset = new Reader(words);
        try {
            return withOffset.read(true);
        } catch (IllegalArgumentException e) {
            return withoutOffset(words, withOffset, e);
        }
    }

    /// When it can't be read in this way either, the error is that of the way that got further.
    private static GraphFile withoutOffset(String[] words, Reader other, IllegalArgumentException error) {
        var reader = new Reader(words);
        try {
            return reader.read(false);
        } catch (IllegalArgumentException e) {
            throw reader.position > other.position ? e : error;
        }
    }

    /// Paths along the edges.
    ///
    /// @param speed of the robots [m/s]
    /// @param stop time that a robot loses at each place [s]
    public PatrolGraph graph(double speed, double stop) {
        return PatrolGraph.ofEdges(mapFromPlaces.size(), edges, speed, stop);
    }

    private static final class Reader {
        private final String[] words;
        private int position;

        Reader(String[] words) {
            this.words = words;
        }

        GraphFile read(boolean offset) {
            int size = whole("number of places", 1, PatrolGraph.MOST);
            number("width [pixels]", 1, MOST_PIXELS);
            number("height [pixels]", 1, MOST_PIXELS);
            double resolution = number("resolution [m]", 1e-4, 100);
            double offsetX = offset ? number("offset x [m]", -1e6, 1e6) : 0;
            double offsetY = offset ? number("offset y [m]", -1e6, 1e6) : 0;
            var places = new ArrayList<Point2d>();
            var lengths = new double[size][];
            var neighbors = new int[size][];
            for (int place = 0; place < size; place++) {
                String of = " of place " + place;
                whole("number" + of, place, place);
                double x = number("x" + of, -MOST_PIXELS, MOST_PIXELS) * resolution + offsetX;
                double y = number("y" + of, -MOST_PIXELS, MOST_PIXELS) * resolution + offsetY;
                places.add(new Point2d(x, y));
                int degree = whole("number of neighbors" + of, 0, Math.min(size - 1, MOST_NEIGHBORS));
                neighbors[place] = new int[degree];
                lengths[place] = new double[degree];
                for (int i = 0; i < degree; i++) {
                    neighbors[place][i] = whole("neighbor %d%s".formatted(i + 1, of), 0, size - 1);
                    direction(of);
                    lengths[place][i] = number("length of edge %d%s".formatted(i + 1, of), 0, MOST_PIXELS) * resolution;
                    if (neighbors[place][i] == place) {
                        throw new IllegalArgumentException("Place %d has itself as a neighbor.".formatted(place));
                    }
                }
            }
            if (position < words.length) {
                throw new IllegalArgumentException("After the last place %d there is '%s', and nothing may follow."
                        .formatted(size - 1, words[position]));
            }
            return new GraphFile(places, edges(neighbors, lengths, resolution));
        }

        /// Edges of length 0, which some files have between places on one pixel, count as one pixel.
        private static List<PatrolGraph.Edge> edges(int[][] neighbors, double[][] lengths, double resolution) {
            var edges = new ArrayList<PatrolGraph.Edge>();
            for (int place = 0; place < neighbors.length; place++) {
                for (int i = 0; i < neighbors[place].length; i++) {
                    int other = neighbors[place][i];
                    double length = Math.max(lengths[place][i], resolution);
                    double back = back(neighbors[other], lengths[other], place);
                    if (other > place || Double.isInfinite(back)) {
                        edges.add(new PatrolGraph.Edge(place, other, Math.min(length, Math.max(back, resolution))));
                    }
                }
            }
            return edges;
        }

        private static double back(int[] neighbors, double[] lengths, int place) {
            double least = Double.POSITIVE_INFINITY;
            for (int i = 0; i < neighbors.length; i++) {
                least = neighbors[i] == place ? Math.min(least, lengths[i]) : least;
            }
            return least;
        }

        private String word(String what) {
            if (position == words.length) {
                throw new IllegalArgumentException("The graph ends before the %s.".formatted(what));
            }
            return words[position++];
        }

        private void direction(String of) {
            String word = word("direction of a neighbor" + of);
            if (!DIRECTION.matcher(word).matches()) {
                throw new IllegalArgumentException(
                        "The direction of a neighbor%s is '%s'. It is one to three letters, such as NE."
                                .formatted(of, shortened(word)));
            }
        }

        private int whole(String what, int least, int most) {
            String word = word(what);
            try {
                int value = Integer.parseInt(word);
                if (value >= least && value <= most) {
                    return value;
                }
            } catch (NumberFormatException _) {
                // said below
            }
            throw new IllegalArgumentException("The %s is '%s'. It must be %s."
                    .formatted(
                            what,
                            shortened(word),
                            least == most
                                    ? String.valueOf(least)
                                    : "a whole number from %d to %d".formatted(least, most)));
        }

        private double number(String what, double least, double most) {
            String word = word(what);
            try {
                double value = Double.parseDouble(word);
                if (value >= least && value <= most) {
                    return value;
                }
            } catch (NumberFormatException _) {
                // said below
            }
            throw new IllegalArgumentException(
                    "The %s is '%s'. It must be a number from %s to %s.".formatted(what, shortened(word), least, most));
        }

        private static String shortened(String word) {
            return word.length() <= 20 ? word : word.substring(0, 20) + "…";
        }
    }
}
